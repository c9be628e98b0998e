// Age of the shown frame; an old one is highlighted.
#pragma once

#include "widgets/translated.h"

#include <QLabel>
#include <optional>

namespace alltact {

class AgeLabel : public Translated<QLabel> {
  Q_OBJECT
 public:
  explicit AgeLabel(QWidget* parent = nullptr);
  /// From capture to display; nullopt: the source gives no capture time.
  void show_age(std::optional<double> age_ms);
  /// Above it a hand and its image move visibly apart.
  static constexpr double kLate_ms = 200;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void show_now();
  void colour();
  std::optional<double> age_ms_;
  bool is_late_ = false;
};

}  // namespace alltact
