#include "app/studio/notification_bar.h"

#include "calibration/reference/settings_record.h"
#include "core/io/disk_wait.h"
#include "widgets/language.h"

namespace alltact {
namespace {

/// A warning or a remark: a sentence alone.
Problem note_of(const Message& sentence) {
  return Problem::of(Error{sentence, "", ""}, Meaning::kDoubtful);
}

}  // namespace

NotificationBar::NotificationBar(const LiveSession& session,
                                 const SessionStore& store,
                                 const Pedal& pedal,
                                 Workspace& work,
                                 const std::vector<Page*>& pages,
                                 std::function<std::vector<std::filesystem::path>()> slow_files)
    : session_(session),
      session_store_(store),
      pedal_(pedal),
      work_(work),
      pages_(pages),
      slow_files_(std::move(slow_files)) {
  connect(&session_, &LiveSession::status_ready, this, &NotificationBar::follow);
  connect(&pedal_, &Pedal::changed, this, &NotificationBar::follow);
  connect(&work_, &Workspace::source_changed, this, [this] { open_error_.reset(); });
  connect(&work_, &Workspace::finger_changed, this, [this] { open_error_.reset(); });
  say([this] { follow(); });
}

void NotificationBar::follow() {
  Problems problems;
  add_session_problems(problems);
  add_disk_problems(problems);
  add_pedal_problems(problems);
  add_source_problems(problems);
  add_finger_problems(problems);
  for (Page* page : pages_) page->add_problems(problems);
  set_problems(std::move(problems));
}

void NotificationBar::show_error(const Error& why) {
  open_error_ = why;
  follow();
}

void NotificationBar::forget_crash() {
  is_crash_reported_ = true;
  follow();
}

void NotificationBar::add_session_problems(Problems& problems) {
  if (session_store_.has_crashed() && !is_crash_reported_)
    problems.push_back({Meaning::kDoubtful,
                        tr("The program ended unexpectedly last time."),
                        tr("What was worked on is kept."),
                        tr("&Go on with it"),
                        [this] { Q_EMIT continue_requested(); }});
  if (const auto unkept = session_store_.problem())
    problems.push_back(Problem::of(*unkept, Meaning::kDoubtful));
}

/// One sentence for a disk that holds up many files.
void NotificationBar::add_disk_problems(Problems& problems) const {
  if (!slow_files_) return;
  const auto files = slow_files_();
  if (!files.empty()) problems.push_back(Problem::of(slow_disk(files.front()), Meaning::kDoubtful));
}

void NotificationBar::add_pedal_problems(Problems& problems) const {
  if (const auto& away = pedal_.problem())
    problems.push_back({Meaning::kDoubtful,
                        tr("The foot pedal is not heard now."),
                        window_sentence(away->message()),
                        {},
                        {}});
}

void NotificationBar::add_source_problems(Problems& problems) {
  if (open_error_) problems.push_back(Problem::of(*open_error_));
  const LiveStatus& status = session_.status();
  if (status.source.problem) problems.push_back(Problem::of(*status.source.problem));
  if (status.source.state == SourceState::kEnded)
    problems.push_back({Meaning::kDoubtful,
                        tr("The source has ended; its last picture is shown."),
                        {},
                        tr("&Play it again"),
                        [this, inputs = work_.state().source] { work_.open_source(inputs); }});
  if (status.controller.problem) problems.push_back(Problem::of(*status.controller.problem));
  if (!status.remark.empty()) problems.push_back(note_of(status.remark));
}

void NotificationBar::add_finger_problems(Problems& problems) const {
  const FingerStatus& finger = session_.status().finger;
  if (finger.problem) problems.push_back(Problem::of(*finger.problem));
  for (const Message& warning : finger.warnings) problems.push_back(note_of(warning));
  const auto& view = session_.view();
  if (!view) return;
  if (view->problem) problems.push_back(Problem::of(*view->problem));
  const FramePtr& frame = view->result.frame;
  if (!finger.finger || !finger.has_reference || !frame) return;
  const Message other = other_settings_than_stored(*frame, *finger.finger);
  if (!other.empty()) problems.push_back(note_of(other));
}

}  // namespace alltact
