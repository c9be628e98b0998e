#include "app/studio/edit_menu.h"

#include "app/studio/workspace.h"
#include "widgets/undo_step.h"

namespace alltact {

EditMenu::EditMenu(QUndoStack& undo, const LiveSession& session, QWidget* parent)
    : TranslatedMenu(parent),
      stack_(undo),
      session_(session),
      undo_(addAction(QString())),
      redo_(addAction(QString())) {
  undo_->setShortcut(Qt::CTRL | Qt::Key_Z);
  redo_->setShortcuts({Qt::CTRL | Qt::SHIFT | Qt::Key_Z, Qt::CTRL | Qt::Key_Y});
  connect(undo_, &QAction::triggered, &stack_, &QUndoStack::undo);
  connect(redo_, &QAction::triggered, &stack_, &QUndoStack::redo);
  connect(&stack_, &QUndoStack::indexChanged, this, &EditMenu::follow);
  connect(&session_, &LiveSession::status_ready, this, &EditMenu::follow);
  say([this] {
    setTitle(tr("&Edit"));
    follow();
  });
}

bool EditMenu::would_end_recording(const QUndoCommand* step) const {
  const bool is_recording = session_.status().recording.state == RecordingState::kRunning;
  return is_recording && step != nullptr && Workspace::changes_source(*step);
}

void EditMenu::follow() {
  const bool can_undo = stack_.canUndo(), can_redo = stack_.canRedo();
  undo_->setEnabled(can_undo && !would_end_recording(stack_.command(stack_.index() - 1)));
  redo_->setEnabled(can_redo && !would_end_recording(stack_.command(stack_.index())));
  undo_->setText(can_undo ? tr("&Undo: %1").arg(undo_words(stack_)) : tr("&Undo"));
  redo_->setText(can_redo ? tr("&Redo: %1").arg(redo_words(stack_)) : tr("&Redo"));
}

}  // namespace alltact
