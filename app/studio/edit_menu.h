// The menu Edit: undo and redo, each with what it would take back.
#pragma once

#include "app/studio/translated_menu.h"
#include "widgets/live/live_session.h"

#include <QUndoStack>

namespace alltact {

/// A key pressed once too often must not cost a recording: while one runs no step is taken back
/// that opens another source. Whoever wants one meanwhile chooses it.
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
