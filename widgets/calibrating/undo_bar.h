// Undo and redo buttons, to compare the page before and after the last change.
#pragma once

#include "widgets/live/live_session.h"
#include "widgets/translated.h"

#include <QToolButton>
#include <QUndoStack>

namespace alltact {

/// The text names the step to be undone. Disabled while a recording runs: a step may open another
/// source.
class UndoBar : public Translated<QWidget> {
  Q_OBJECT
 public:
  UndoBar(QUndoStack& undo, const LiveSession& session, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void follow();
  void set_icons();

  QUndoStack& stack_;
  const LiveSession& session_;
  QToolButton *undo_, *redo_;
};

}  // namespace alltact
