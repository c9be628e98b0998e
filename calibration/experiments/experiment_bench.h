// What all experiments of the source paper share here: one simulated finger, recorded and
// calibrated, and scenes of it that are measured frame by frame beside their truth.
#pragma once

#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"
#include "core/simulation/plan.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct BenchOptions {
  /// For the fingers. What earlier experiments left there goes: experiment_finger and
  /// experiment_hd_finger.
  std::filesystem::path folder;
  std::uint64_t seed = 1;  ///< of everything random
  int threads = 1;         ///< that render; the figures are the same for any number
};

class ExperimentBench {
 public:
  /// Makes the demonstration's finger: recorded with the scene demo_reference and calibrated with
  /// demo_presses. Errors: a scene that is missing or wrong; those of install_reference() and
  /// calibrate_finger(); stopped.
  [[nodiscard]] static Result<ExperimentBench> make(const BenchOptions& options, const Job& job);

  [[nodiscard]] const FingerSnapshot& finger() const { return *finger_; }
  [[nodiscard]] const BenchOptions& options() const { return options_; }
  [[nodiscard]] const Job& job() const { return *job_; }
  /// The untouched finger as it is in the frame of the recording that counts as rest.
  [[nodiscard]] const Truth& truth_at_rest() const { return truth_at_rest_; }

  /// A scene of the resources by its file's name without the ending.
  [[nodiscard]] Result<Plan> plan(const std::string& scene) const;

  /// Told of every frame, in order.
  ///   which: of the settings that the frame was measured with
  using Take =
      std::function<void(std::size_t which, const Truth& truth, const FrameResult& result)>;

  /// Measures all frames of a scene, each by itself and with each of the settings. Gives the number
  /// of frames. Errors: those of plan() and Pipeline; stopped.
  [[nodiscard]] Result<int> measure(const std::string& scene,
                                    const std::vector<PipelineSettings>& settings,
                                    const Take& take) const;

  /// The picture of a frame as a source would give it.
  [[nodiscard]] FramePtr frame(const Plan& plan, int number) const;

  /// Makes a finger for the scene `recording` in a folder of its own below that of the options:
  /// described as the scene has it, with that recording as its reference, not calibrated.
  struct Recorded {
    Finger finger;
    std::filesystem::path folder;
    Truth truth_at_rest;
  };
  [[nodiscard]] static Result<Recorded> record(const std::string& recording,
                                               const std::string& folder,
                                               const BenchOptions& options,
                                               const Job& job);

 private:
  ExperimentBench(BenchOptions options, const Job& job)
      : options_(std::move(options)), job_(&job) {}

  BenchOptions options_;
  const Job* job_;
  FingerPtr finger_;
  std::optional<ReferenceLibrary> library_;  // held, so that every pipeline shares what was read
  Truth truth_at_rest_;
};

}  // namespace alltact
