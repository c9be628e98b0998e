// What is wrong with all that runs, above every place; nothing when all is well.
#pragma once

#include "app/studio/session_keeper.h"
#include "app/studio/workspace.h"
#include "widgets/live/pedal.h"
#include "widgets/places/place.h"

namespace alltact {

class ProblemBar : public ProblemList {
  Q_OBJECT
 public:
  ProblemBar(const LiveSession& session,
             const SessionKeeper& keeper,
             const Pedal& pedal,
             Workspace& work,
             const std::vector<Place*>& places,
             std::function<std::vector<std::filesystem::path>()> slow_files);

  void follow();
  /// What could not be opened; told until something else is.
  void tell(const Error& why);
  /// Somebody goes on with what was left.
  void forget_crash();

 Q_SIGNALS:
  void go_on_wanted();

 private:
  using Problems = std::vector<Problem>;
  void add_session_problems(Problems& problems);
  void add_disk_problems(Problems& problems) const;
  void add_pedal_problems(Problems& problems) const;
  void add_source_problems(Problems& problems);
  void add_finger_problems(Problems& problems) const;

  const LiveSession& session_;
  const SessionKeeper& keeper_;
  const Pedal& pedal_;
  Workspace& work_;
  std::vector<Place*> places_;
  std::function<std::vector<std::filesystem::path>()> slow_files_;
  bool is_crash_told_ = false;
  std::optional<Error> told_;
};

}  // namespace alltact
