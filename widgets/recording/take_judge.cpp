#include "widgets/recording/take_judge.h"

#include "core/finger/finger.h"

#include <QTemporaryDir>

namespace alltact {
namespace {

namespace fs = std::filesystem;

Result<ReferenceReport> judged(const ReferenceInstaller& installer,
                               const fs::path& finger,
                               const fs::path& video,
                               const ReferenceChoices& choices,
                               const Job& job) {
  const QTemporaryDir folder;
  std::error_code failed;
  if (!folder.isValid())
    return Error{en::say("there is no room to try the recording in"),
                 fs::temp_directory_path(failed).string(),
                 en::say("freeing some space on the disk")};
  const fs::path copy = folder.path().toStdString();
  fs::copy_file(finger / Finger::kFileName, copy / Finger::kFileName, failed);
  if (failed)
    return Error{en::say("the finger could not be copied: {}", failed.message()),
                 (finger / Finger::kFileName).string(),
                 ""};
  return installer(copy, video, choices, job);
}

}  // namespace

TakeJudge::TakeJudge(ReferenceInstaller installer, QObject* parent)
    : QObject(parent), installer_(std::move(installer)) {
  connect(&work_, &BackgroundWork::progressed, this, &TakeJudge::changed);
  connect(&work_, &BackgroundWork::finished, this, [this] {
    begin();
    Q_EMIT changed();
  });
}

void TakeJudge::judge(const fs::path& finger,
                      const fs::path& video,
                      const ReferenceChoices& choices) {
  forget();
  asked_ = Asked{finger, video, choices};
  if (!work_.is_running()) begin();
}

void TakeJudge::begin() {
  if (!asked_) return;
  const Asked now = *std::exchange(asked_, std::nullopt);
  work_.start([this, now, number = number_, installer = installer_](const Job& job) {
    auto report = std::make_shared<Result<ReferenceReport>>(
        judged(installer, now.finger, now.video, now.choices, job));
    return std::function<void()>([this, report, number, is_stopped = job.stop_requested()] {
      if (number == number_ && !is_stopped) report_ = *report;
    });
  });
  Q_EMIT changed();
}

void TakeJudge::stop() {
  asked_.reset();
  work_.stop();
}

void TakeJudge::forget() {
  stop();
  ++number_;
  report_.reset();
}

}  // namespace alltact
