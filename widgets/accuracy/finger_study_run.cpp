#include "widgets/accuracy/finger_study_run.h"

#include "widgets/value_change.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

/// The name in files of the requested settings.
std::string name_of_use(const PipelineSettings& settings, const PipelineSettings& calibrated) {
  return key_of(settings) == key_of(calibrated) ? std::string()
                                                : words_of(settings, calibrated).english();
}

bool is_same_study(const FingerStudy& a, const FingerStudy& b) {
  const auto flags = [](const FingerStudy& study) {
    return std::array{study.is_of_finger_now,
                      study.is_of_this_computer,
                      study.has_all_single,
                      study.has_all_pairs};
  };
  return a.date == b.date && a.study.rows.size() == b.study.rows.size() && flags(a) == flags(b);
}

}  // namespace

FingerStudyRun::FingerStudyRun(QUndoStack& undo, std::string program_version, QObject* parent)
    : QObject(parent), undo_(undo), version_(std::move(program_version)) {
  connect(&work_, &BackgroundWork::progressed, this, &FingerStudyRun::changed);
  connect(&work_, &BackgroundWork::finished, this, &FingerStudyRun::changed);
  connect(&writing_, &BackgroundWork::finished, this, &FingerStudyRun::write_next);
}

void FingerStudyRun::open(const std::filesystem::path& folder) {
  if (folder != folder_) {
    work_.stop();
    folder_ = folder;
    take({});
  }
  if (!folder.empty()) read_folder();
}

FingerStudyRun::FolderState FingerStudyRun::state_of(const std::filesystem::path& folder) {
  FolderState folder_state;
  const auto finger = open_finger(folder);
  if (!finger) return folder_state;  // the window reports it
  folder_state.finger = *finger;
  auto stored = stored_study(*finger);
  if (!stored)
    folder_state.problem = stored.error();
  else if (*stored)
    folder_state.study = std::make_shared<const FingerStudy>(std::move(**stored));
  const auto measuring = presets_of_finger(folder);
  if (measuring)
    folder_state.in_use = {measuring->used, measuring->now};
  else
    folder_state.problem = measuring.error();
  return folder_state;
}

void FingerStudyRun::read_folder() {
  reading_.restart([this, folder = folder_](const Job&) {
    auto folder_state = std::make_shared<FolderState>(state_of(folder));
    return std::function<void()>([this, folder, folder_state] {
      if (folder != folder_) return;
      // A request that is not written yet takes precedence.
      if (!to_write_.empty() || writing_.is_running()) folder_state->in_use = in_use_;
      take(*folder_state);
    });
  });
}

void FingerStudyRun::take(const FolderState& folder_state) {
  finger_ = folder_state.finger;
  // An unchanged study is not replaced, so that selections in it stay.
  const bool is_same = study_ && folder_state.study && is_same_study(*study_, *folder_state.study);
  if (!is_same) study_ = folder_state.study;
  in_use_ = folder_state.in_use;
  problem_ = folder_state.problem;
  Q_EMIT changed();
}

void FingerStudyRun::start(StudyExtent extent) {
  if (is_running() || !finger_) return;
  problem_.reset();
  work_.start([this, finger = finger_, extent, version = version_](const Job& job) {
    const auto done = study_finger(finger, extent, version, job);
    std::optional<Error> problem;
    if (!done && !job.stop_requested()) problem = done.error();
    auto folder_state = std::make_shared<FolderState>(state_of(finger->folder));
    if (problem) folder_state->problem = problem;
    return std::function<void()>([this, folder = finger->folder, folder_state] {
      if (folder != folder_) return;
      folder_state->in_use = in_use_;
      take(*folder_state);
    });
  });
  Q_EMIT changed();
}

std::optional<std::size_t> FingerStudyRun::row_in_use() const {
  if (!study_) return std::nullopt;
  const auto& rows = study_->study.rows;
  const auto found = std::find_if(rows.begin(), rows.end(), [&](const StudyRow& row) {
    return key_of(row.settings) == key_of(in_use_.settings);
  });
  return found == rows.end() ? std::nullopt
                             : std::optional(static_cast<std::size_t>(found - rows.begin()));
}

void FingerStudyRun::use(std::size_t row) {
  if (!study_ || row_in_use() == row) return;
  const auto& rows = study_->study.rows;
  const PipelineSettings& requested = rows[row].settings;
  undo_.push(new ValueChange<InUse>(
      [] { return tr("use other settings"); },
      in_use_,
      InUse{name_of_use(requested, rows.front().settings), requested},
      [this, folder = folder_](const InUse& value) { set_in_use(folder, value); }));
}

void FingerStudyRun::set_in_use(const std::filesystem::path& folder, const InUse& requested) {
  to_write_.emplace_back(folder, requested);
  if (folder == folder_) in_use_ = requested;
  write_next();
  Q_EMIT changed();
}

void FingerStudyRun::write_next() {
  if (writing_.is_running() || to_write_.empty()) return;
  const auto [folder, requested] = to_write_.front();
  to_write_.pop_front();
  writing_.start([this, folder = folder, requested = requested](const Job&) {
    const auto store = FingerStore::of(folder);
    const Status written = requested.name.empty()
                               ? use_calibrated_settings(*store)
                               : use_settings(*store, requested.settings, requested.name);
    return std::function<void()>([this, folder, written] {
      if (written || folder != folder_) return;
      problem_ = written.error();
      read_folder();
      Q_EMIT changed();
    });
  });
}

}  // namespace alltact
