// The row above every page: the open finger and the open source with their menus, and the finger's
// summary.
#pragma once

#include "app/studio/workspace.h"
#include "widgets/background_work.h"
#include "widgets/shell/finger_card.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <string>

namespace alltact {

// Grade of the open finger, ages of its calibration and its last check, and what is due: one line
// at the window's top, with a button that leads to what is due.

class FingerSummary : public Translated<QWidget> {
  Q_OBJECT
 public:
  FingerSummary(const LiveSession& session, const Workspace& work, QWidget* parent = nullptr);
  /// Of the open finger, read from its folder; nullopt where none is open or it cannot be read.
  [[nodiscard]] const std::optional<FingerCard>& card() const { return card_; }
  /// Others lead to what is due: the guide, or the shown page, which `leads_to` another or none.
  void set_led(bool is_guided, const std::string& page, const std::string& leads_to);

 Q_SIGNALS:
  /// `page`: name of the page where it is done.
  void due_requested(const std::string& page);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  /// On a background thread, where a file was written since.
  void read();
  void show_summary();
  /// By its name.
  [[nodiscard]] std::string due_page() const;

  const LiveSession& session_;
  const Workspace& work_;
  std::optional<FingerCard> card_;
  std::filesystem::path read_;  // the folder card_ is of
  std::string written_;         // modification times of its files, as of card_
  bool is_guided_ = false;
  std::string page_, leads_to_;
  QTimer poll_timer_;  // for checks, and files that other programs write
  QLabel* symbol_;
  ElidedLabel* text_;
  QPushButton* due_;
  BackgroundWork reading_;
};

class HeaderBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  HeaderBar(const LiveSession& session, const Workspace& work, QMenu& finger_menu,
            QMenu& source_menu);
  [[nodiscard]] FingerSummary& summary() { return *summary_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_button(QLabel* label, QToolButton* button, QMenu& menu);
  void set_icons();
  void follow();
  [[nodiscard]] QString finger_name() const;
  [[nodiscard]] QString cut_to_button(const QString& name) const;

  const LiveSession& session_;
  const Workspace& work_;
  QLabel *finger_label_, *source_label_;
  QToolButton *finger_, *source_;
  FingerSummary* summary_;
};

}  // namespace alltact
