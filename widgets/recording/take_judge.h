// What a recording would bring as a finger's reference, before it is installed.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "widgets/background_work.h"

#include <QTemporaryDir>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace alltact {

/// Installs a recording in a finger's folder; runs on a thread of its own.
using ReferenceInstaller =
    std::function<Result<ReferenceReport>(const std::filesystem::path& folder,
                                          const std::filesystem::path& video,
                                          const ReferenceChoices& choices,
                                          const Job& job)>;

/// A recording that was installed in a copy of a finger.
struct JudgedTake {
  Result<ReferenceReport> report;
  std::shared_ptr<const QTemporaryDir> copy;  ///< the finger's; gone with the last who holds it
  std::string described;                      ///< finger.yaml as it was copied
  std::filesystem::path finger, video;

  /// Gives the finger what its copy got. False: it has changed since, or there is more to keep than
  /// a reference, so that the recording has to be installed by itself. For a background thread.
  [[nodiscard]] Result<bool> install() const;
};

/// Installs it in a copy of the finger: what it says is what installing gives.
class TakeJudge : public QObject {
  Q_OBJECT
 public:
  explicit TakeJudge(ReferenceInstaller installer, QObject* parent = nullptr);

  /// finger: its folder; it stays as it is.
  void judge(const std::filesystem::path& finger,
             const std::filesystem::path& video,
             const ReferenceChoices& choices);
  /// Keeps what is known.
  void stop();
  void forget();
  [[nodiscard]] bool is_working() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }
  /// Of the video that was asked for last; nullptr: not known.
  [[nodiscard]] const std::shared_ptr<const JudgedTake>& judged() const { return judged_; }

 Q_SIGNALS:
  void changed();

 private:
  ReferenceInstaller installer_;
  int number_ = 0;  // of what was asked for last
  std::shared_ptr<const JudgedTake> judged_;
  BackgroundWork work_, clearing_;
};

}  // namespace alltact
