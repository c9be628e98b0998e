// Previews a recording as a finger's reference before it is installed.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "widgets/background_work.h"

#include <QTemporaryDir>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

namespace alltact {

/// Installs a recording in a finger's folder; runs on a background thread.
using ReferenceInstaller =
    std::function<Result<ReferenceReport>(const std::filesystem::path& folder,
                                          const std::filesystem::path& video,
                                          const ReferenceChoices& choices,
                                          const Job& job)>;

/// A recording that was installed in a copy of a finger.
struct JudgedTake {
  Result<ReferenceReport> report;
  std::shared_ptr<const QTemporaryDir> copy;  ///< copy of the finger; removed with its last owner
  std::string finger_yaml;                    ///< finger.yaml as it was copied
  std::filesystem::path finger, video;

  /// Copies the new reference to the finger. False: the finger has changed since, or files other
  /// than a reference are to be stored, so that the recording must be installed directly. For a
  /// background thread.
  [[nodiscard]] Result<bool> install() const;
};

/// Installs the recording in a copy of the finger, so that the report equals that of the
/// installation.
class TakeJudge : public QObject {
  Q_OBJECT
 public:
  explicit TakeJudge(ReferenceInstaller installer, QObject* parent = nullptr);

  /// finger: its folder, which stays unchanged.
  void judge(const std::filesystem::path& finger,
             const std::filesystem::path& video,
             const ReferenceChoices& choices);
  /// Stops the run; a finished report is retained.
  void stop();
  void forget();
  [[nodiscard]] bool is_working() const { return work_.is_running(); }
  [[nodiscard]] const BackgroundWork& work() const { return work_; }
  /// Result for the last judged video; nullptr: not known.
  [[nodiscard]] const std::shared_ptr<const JudgedTake>& judged() const { return judged_; }

 Q_SIGNALS:
  void changed();

 private:
  ReferenceInstaller installer_;
  int number_ = 0;  // of the last request
  std::shared_ptr<const JudgedTake> judged_;
  BackgroundWork work_, clearing_;
};

}  // namespace alltact
