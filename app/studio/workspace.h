// What is worked on: a finger and a source of pictures, which can be taken back like everything
// else, and what was chosen for them.
#pragma once

#include "app/studio/session_file.h"
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
  /// `session` shows what is open; changes go through `undo`.
  Workspace(LiveSession& session, QUndoStack& undo, const std::optional<SessionState>& last);

  /// Both can be undone. An empty one closes; what is open already is opened afresh.
  void open_finger(const std::filesystem::path& folder);
  void open_source(const Inputs& inputs);
  /// Not undoable: what the program was started with. Empty ones are passed over.
  void begin_with(const std::filesystem::path& finger, const Inputs& source);
  /// What was set by hand of the camera that is open, to be set again whenever it is.
  void keep_control(const ControlValue& control);
  void keep_lock(bool is_locked);

  /// All but `place`, `view` and `inspect`.
  [[nodiscard]] const SessionState& state() const { return state_; }
  /// "none" in the window's language where there is none.
  [[nodiscard]] QString source_name() const;
  [[nodiscard]] static bool changes_source(const QUndoCommand& step);

 Q_SIGNALS:
  /// Another one is open, or none.
  void finger_changed();
  /// What stands in the open one's folder has changed, whoever did that; the live picture follows
  /// it.
  void finger_rewritten();
  void source_changed();
  /// Anything of state().
  void changed();

 private:
  void set_finger(const std::filesystem::path& folder);
  void set_source(const Inputs& inputs);
  [[nodiscard]] std::vector<ControlValue>& kept_controls();
  void listen_to_finger();

  LiveSession& session_;
  QUndoStack& undo_;
  SessionState state_;
  std::shared_ptr<FingerStore> store_;
  std::shared_ptr<void> listening_;
  QTimer look_;  // for what other programs write
  BackgroundWork looking_;
};

/// A file or folder as people call it: the last part of its path.
[[nodiscard]] QString short_name(const std::filesystem::path& path);

}  // namespace alltact
