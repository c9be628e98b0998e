#include "widgets/accuracy/finger_study_run.h"

#include "widgets/value_change.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

/// What a person asked for, in the words of files.
std::string name_of_use(const PipelineSettings& settings, const PipelineSettings& calibrated) {
  return key_of(settings) == key_of(calibrated) ? std::string()
                                                : words_of(settings, calibrated).english();
}

bool says_the_same(const FingerStudy& a, const FingerStudy& b) {
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
  if (!folder.empty()) look();
}

FingerStudyRun::Looked FingerStudyRun::look_at(const std::filesystem::path& folder) {
  Looked looked;
  const auto finger = open_finger(folder);
  if (!finger) return looked;  // the window says so
  looked.finger = *finger;
  auto kept = kept_study(*finger);
  if (!kept)
    looked.problem = kept.error();
  else if (*kept)
    looked.study = std::make_shared<const FingerStudy>(std::move(**kept));
  const auto measuring = presets_of_finger(folder);
  if (measuring)
    looked.in_use = {measuring->used, measuring->now};
  else
    looked.problem = measuring.error();
  return looked;
}

void FingerStudyRun::look() {
  looking_.restart([this, folder = folder_](const Job&) {
    auto looked = std::make_shared<Looked>(look_at(folder));
    return std::function<void()>([this, folder, looked] {
      if (folder != folder_) return;
      // What was asked for and is not written yet is what counts.
      if (!to_write_.empty() || writing_.is_running()) looked->in_use = in_use_;
      take(*looked);
    });
  });
}

void FingerStudyRun::take(const Looked& looked) {
  finger_ = looked.finger;
  // The same one again is no other one: what was chosen in it stays.
  const bool is_same = study_ && looked.study && says_the_same(*study_, *looked.study);
  if (!is_same) study_ = looked.study;
  in_use_ = looked.in_use;
  problem_ = looked.problem;
  Q_EMIT changed();
}

void FingerStudyRun::start(StudyExtent extent) {
  if (is_running() || !finger_) return;
  problem_.reset();
  work_.start([this, finger = finger_, extent, version = version_](const Job& job) {
    const auto done = study_finger(finger, extent, version, job);
    std::optional<Error> problem;
    if (!done && !job.stop_requested()) problem = done.error();
    auto looked = std::make_shared<Looked>(look_at(finger->folder));
    if (problem) looked->problem = problem;
    return std::function<void()>([this, folder = finger->folder, looked] {
      if (folder != folder_) return;
      looked->in_use = in_use_;
      take(*looked);
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
  const PipelineSettings& wanted = rows[row].settings;
  undo_.push(new ValueChange<InUse>(
      [] { return tr("use other settings"); },
      in_use_,
      InUse{name_of_use(wanted, rows.front().settings), wanted},
      [this, folder = folder_](const InUse& value) { set_in_use(folder, value); }));
}

void FingerStudyRun::set_in_use(const std::filesystem::path& folder, const InUse& wanted) {
  to_write_.emplace_back(folder, wanted);
  if (folder == folder_) in_use_ = wanted;
  write_next();
  Q_EMIT changed();
}

void FingerStudyRun::write_next() {
  if (writing_.is_running() || to_write_.empty()) return;
  const auto [folder, wanted] = to_write_.front();
  to_write_.pop_front();
  writing_.start([this, folder = folder, wanted = wanted](const Job&) {
    const auto store = FingerStore::of(folder);
    const Status written = wanted.name.empty() ? use_calibrated_settings(*store)
                                               : use_settings(*store, wanted.settings, wanted.name);
    return std::function<void()>([this, folder, written] {
      if (written || folder != folder_) return;
      problem_ = written.error();
      look();
      Q_EMIT changed();
    });
  });
}

}  // namespace alltact
