// Problems of everything that runs, above every page; hidden without problems.
#pragma once

#include "app/studio/session_store.h"
#include "app/studio/workspace.h"
#include "widgets/live/pedal.h"
#include "widgets/pages/page.h"

namespace alltact {

class NotificationBar : public ProblemList {
  Q_OBJECT
 public:
  NotificationBar(const LiveSession& session,
                  const SessionStore& store,
                  const Pedal& pedal,
                  Workspace& work,
                  const std::vector<Page*>& pages,
                  std::function<std::vector<std::filesystem::path>()> slow_files);

  void follow();
  /// Shows what could not be opened, until something else is.
  void show_error(const Error& why);
  /// The user continues the session from before the crash.
  void forget_crash();

 Q_SIGNALS:
  void continue_requested();

 private:
  using Problems = std::vector<Problem>;
  void add_session_problems(Problems& problems);
  void add_disk_problems(Problems& problems) const;
  void add_pedal_problems(Problems& problems) const;
  void add_source_problems(Problems& problems);
  void add_finger_problems(Problems& problems) const;

  const LiveSession& session_;
  const SessionStore& session_store_;
  const Pedal& pedal_;
  Workspace& work_;
  std::vector<Page*> pages_;
  std::function<std::vector<std::filesystem::path>()> slow_files_;
  bool is_crash_reported_ = false;
  std::optional<Error> open_error_;
};

}  // namespace alltact
