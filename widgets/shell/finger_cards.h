// Recently used fingers, a card each: image, name, grade of the calibration, dates of calibration
// and check, and what is due.
#pragma once

#include "widgets/background_work.h"
#include "widgets/shell/finger_card.h"
#include "widgets/translated.h"

#include <QGridLayout>
#include <QToolButton>
#include <vector>

namespace alltact {

class FingerCards : public Translated<QWidget> {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxCards = 6;

  explicit FingerCards(QWidget* parent = nullptr);
  /// Latest first; read on a background thread. Missing or unreadable folders, and all after
  /// kMaxCards, are left out; hidden where none is left.
  void set_fingers(const std::vector<std::filesystem::path>& folders);
  [[nodiscard]] const std::vector<FingerCard>& cards() const { return cards_; }

 Q_SIGNALS:
  void finger_chosen(const QString& folder);
  /// The folders, also after kMaxCards, with a finger that can be opened.
  void found(const std::vector<std::filesystem::path>& folders);
  /// cards() are shown.
  void filled();

 protected:
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void read();
  void rebuild();
  void fit();
  [[nodiscard]] QToolButton* make_button(const FingerCard& card);

  std::vector<std::filesystem::path> folders_;
  std::vector<FingerCard> cards_;
  QGridLayout* grid_;
  BackgroundWork reading_;
};

}  // namespace alltact
