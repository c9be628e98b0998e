// The row above every page: the open finger and the open source with their menus, and the finger's
// summary.
#pragma once

#include "app/studio/finger_summary.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QMenu>
#include <QToolButton>

namespace alltact {

class HeaderBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  HeaderBar(const LiveSession& session,
            const Workspace& work,
            QMenu& finger_menu,
            QMenu& source_menu);
  [[nodiscard]] FingerSummary& summary() { return *summary_; }

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void add_button(QLabel* label, QToolButton* button, QMenu& menu);
  void set_icons();
  void follow();
  [[nodiscard]] QString finger_name() const;

  const LiveSession& session_;
  const Workspace& work_;
  QLabel *finger_label_, *source_label_;
  QToolButton *finger_, *source_;
  FingerSummary* summary_;
};

}  // namespace alltact
