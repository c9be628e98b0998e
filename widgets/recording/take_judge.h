// What a recording would bring as a finger's reference, before it is installed.
#pragma once

#include "calibration/reference/reference_recording.h"
#include "widgets/background_work.h"

#include <filesystem>
#include <functional>
#include <optional>

namespace alltact {

/// Installs a recording in a finger's folder; runs on a thread of its own.
using ReferenceInstaller =
    std::function<Result<ReferenceReport>(const std::filesystem::path& folder,
                                          const std::filesystem::path& video,
                                          const ReferenceChoices& choices,
                                          const Job& job)>;

/// Installs it in a copy of the finger that is thrown away again: what it says is what installing
/// gives.
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
  /// Of the video that was asked for last; nullopt: not known.
  [[nodiscard]] const std::optional<Result<ReferenceReport>>& report() const { return report_; }

 Q_SIGNALS:
  void changed();

 private:
  void begin();
  struct Asked {
    std::filesystem::path finger, video;
    ReferenceChoices choices;
  };
  ReferenceInstaller installer_;
  std::optional<Asked> asked_;  // and not begun yet
  int number_ = 0;              // of what was asked for last
  std::optional<Result<ReferenceReport>> report_;
  BackgroundWork work_;
};

}  // namespace alltact
