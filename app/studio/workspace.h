// The open finger and the open source of frames, both undoable, and the choices made for them.
#pragma once

#include "app/studio/session.h"
#include "core/finger/finger_store.h"
#include "widgets/background_work.h"
#include "widgets/live/live_session.h"

#include <QTimer>
#include <QUndoStack>

namespace alltact {

class Workspace : public QObject {
  Q_OBJECT
 public:
  using Inputs = std::vector<std::filesystem::path>;

  /// Begins with nothing open, and with the recent fingers and the cameras' controls of `last`.
  /// `session` shows the open ones; changes go through `undo`.
  Workspace(LiveSession& session, QUndoStack& undo, const std::optional<SessionState>& last);

  /// No step to undo, and forgets the steps on the finger before. An empty one closes; one that is
  /// open already is opened again.
  void open_finger(const std::filesystem::path& folder);
  /// Can be undone. An empty one closes; one that is open already is opened again.
  void open_source(const Inputs& inputs);
  /// Not undoable: the program's arguments. Empty ones are ignored.
  void begin_with(const std::filesystem::path& finger, const Inputs& source);
  /// Its folder stays.
  void forget_finger(const std::filesystem::path& folder);
  /// A value set by hand for the open camera, which is set again whenever it is opened.
  void store_control(const ControlValue& control);
  void store_lock(bool is_locked);

  /// All but `page`, `view` and `inspect`.
  [[nodiscard]] const SessionState& state() const { return state_; }
  /// "none" in the window's language where there is none.
  [[nodiscard]] QString source_name() const;
  [[nodiscard]] static bool changes_source(const QUndoCommand& step);

 Q_SIGNALS:
  /// Another one is open, or none.
  void finger_changed();
  void recent_fingers_changed();
  /// Files in the open one's folder have changed, by this or another program; the live image
  /// follows.
  void finger_rewritten();
  void source_changed();
  /// Any part of state().
  void changed();

 private:
  void set_finger(const std::filesystem::path& folder);
  void set_source(const Inputs& inputs);
  [[nodiscard]] std::vector<ControlValue>& stored_controls();
  void listen_to_finger();

  LiveSession& session_;
  QUndoStack& undo_;
  SessionState state_;
  std::shared_ptr<FingerStore> store_;
  std::shared_ptr<void> listening_;
  QTimer poll_timer_;  // for files that other programs write
  BackgroundWork polling_;
};

/// The displayed name of a file or folder: the last part of its path.
[[nodiscard]] QString short_name(const std::filesystem::path& path);

}  // namespace alltact
