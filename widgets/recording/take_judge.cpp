#include "widgets/recording/take_judge.h"

#include "calibration/reference/make_reference.h"
#include "calibration/reference/new_reference.h"
#include "core/finger/finger.h"
#include "core/io/atomic_file.h"

namespace alltact {
namespace {

namespace fs = std::filesystem;

fs::path path_of(const QTemporaryDir& folder) {
  return folder.path().toStdString();
}

JudgedTake judge_take(const ReferenceInstaller& installer,
                      const fs::path& finger,
                      const fs::path& video,
                      const ReferenceChoices& choices,
                      const Job& job) {
  const auto copy = std::make_shared<const QTemporaryDir>();
  const auto judged = [&](Result<ReferenceReport> report, std::string finger_yaml = {}) {
    return JudgedTake{std::move(report), copy, std::move(finger_yaml), finger, video};
  };
  std::error_code failed;
  if (!copy->isValid())
    return judged(Error{en::say("there is no room to try the recording in"),
                        fs::temp_directory_path(failed).string(),
                        en::say("freeing some space on the disk")});
  auto finger_yaml = read_file(finger / Finger::kFileName);
  if (!finger_yaml) return judged(finger_yaml.error());
  const Status copied = write_file_atomically(path_of(*copy) / Finger::kFileName, *finger_yaml);
  if (!copied) return judged(copied.error());
  // The earlier reference helps to judge the recording; without it the recording is judged alone.
  for (const char* name : {kReferenceVideo, kReferenceTable})
    fs::create_symlink(finger / name, path_of(*copy) / name, failed);
  return judged(installer(path_of(*copy), video, choices, job), std::move(*finger_yaml));
}

}  // namespace

Result<bool> JudgedTake::install() const {
  const auto now = read_file(finger / Finger::kFileName);
  if (!now) return now.error();
  std::error_code absent;
  const bool is_all = report.ok() && !fs::exists(path_of(*copy) / kReferenceProblem, absent);
  if (!is_all || *now != finger_yaml) return false;
  if (const Status given = copy_reference(path_of(*copy), finger); !given) return given.error();
  fs::remove(finger / kReferenceProblem, absent);  // of an earlier recording
  return true;
}

TakeJudge::TakeJudge(ReferenceInstaller installer, QObject* parent)
    : QObject(parent), installer_(std::move(installer)) {
  connect(&work_, &BackgroundWork::progressed, this, &TakeJudge::changed);
  connect(&work_, &BackgroundWork::finished, this, &TakeJudge::changed);
}

void TakeJudge::judge(const fs::path& finger,
                      const fs::path& video,
                      const ReferenceChoices& choices) {
  forget();
  work_.restart(
      [this, finger, video, choices, number = number_, installer = installer_](const Job& job) {
        const auto judged =
            std::make_shared<const JudgedTake>(judge_take(installer, finger, video, choices, job));
        return std::function<void()>([this, judged, number, is_stopped = job.stop_requested()] {
          if (number == number_ && !is_stopped) judged_ = judged;
        });
      });
  Q_EMIT changed();
}

void TakeJudge::stop() {
  work_.stop();
}

void TakeJudge::forget() {
  stop();
  ++number_;
  if (!judged_) return;
  // The copy may be large, so it is removed on a background thread.
  clearing_.start([judged = std::exchange(judged_, nullptr)](const Job&) mutable {
    judged.reset();
    return std::function<void()>([] {});
  });
}

}  // namespace alltact
