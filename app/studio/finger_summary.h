// What the open finger is worth, how old its calibration and its last check are, and what is due:
// in one line at the window's top, with a button that leads to what is due.
#pragma once

#include "app/studio/workspace.h"
#include "widgets/background_work.h"
#include "widgets/shell/finger_card.h"
#include "widgets/shell/one_line.h"
#include "widgets/translated.h"

#include <QPushButton>
#include <QTimer>
#include <string>

namespace alltact {

class FingerSummary : public Translated<QWidget> {
  Q_OBJECT
 public:
  FingerSummary(const LiveSession& session, const Workspace& work, QWidget* parent = nullptr);
  /// Of the open finger, as its folder stands; empty where none is open or it cannot be read.
  [[nodiscard]] const std::optional<FingerCard>& card() const { return card_; }

 Q_SIGNALS:
  /// Done at the place of that name.
  void due_wanted(const std::string& place);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  /// Beside the window, where something was written since.
  void read();
  void tell();

  const LiveSession& session_;
  const Workspace& work_;
  std::optional<FingerCard> card_;
  std::filesystem::path read_;  // the folder card_ is of
  std::string written_;         // when its files were, as card_ has them
  QTimer look_;                 // for checks, and what other programs write
  QLabel* symbol_;
  OneLine* text_;
  QPushButton* due_;
  BackgroundWork reading_;
};

}  // namespace alltact
