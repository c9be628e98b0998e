// How old the picture is that one sees; an old one stands out.
#pragma once

#include "widgets/translated.h"

#include <QLabel>
#include <optional>

namespace alltact {

class AgeLabel : public Translated<QLabel> {
  Q_OBJECT
 public:
  explicit AgeLabel(QWidget* parent = nullptr);
  /// From being taken to being shown; nullopt: the source does not tell when.
  void show_age(std::optional<double> age_ms);
  /// Above it a hand and the picture of it are seen apart.
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
