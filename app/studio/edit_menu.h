// The menu Edit: undo and redo, each with the name of its step.
#pragma once

#include "app/studio/translated_menu.h"
#include "widgets/live/live_session.h"

#include <QUndoStack>

namespace alltact {

/// An accidental shortcut must not end a recording: while one runs, shortcuts do not undo a step
/// that opens another source. The menu entry still does.
class EditMenu : public TranslatedMenu {
  Q_OBJECT
 public:
  EditMenu(QUndoStack& undo, const LiveSession& session, QWidget* parent);

 private:
  void follow();
  [[nodiscard]] bool would_end_recording(const QUndoCommand* step) const;

  QUndoStack& stack_;
  const LiveSession& session_;
  QAction *undo_, *redo_;
};

}  // namespace alltact
