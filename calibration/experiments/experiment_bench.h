// Common setup of the source paper's experiments: a simulated finger, recorded and calibrated, and
// scenes of it that are measured frame by frame with their ground truth.
#pragma once

#include "calibration/experiments/finger_variant.h"
#include "calibration/force/train_force.h"
#include "core/finger/finger_store.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"
#include "core/simulation/plan.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct BenchOptions {
  /// Folder for the fingers. Those of earlier experiments are removed: experiment_finger,
  /// experiment_finger_1 and so on, and experiment_hd_finger.
  std::filesystem::path folder;
  std::uint64_t seed = 1;  ///< of everything random
  int threads = 1;         ///< for rendering; the figures are the same for any number
  FingerVariant finger;    ///< the demonstration's
  /// Only every n-th frame of a recording is used: fewer cost less, and leave poses without a near
  /// one.
  int recording_every = 1;
  std::string name = "experiment_finger";  ///< of the finger's folder below `folder`
  /// Cache of fingers for later runs (finger_cache.h); empty: no cache.
  std::optional<std::filesystem::path> cache;
};

class ExperimentBench {
 public:
  /// Makes the finger: recorded with the scene demo_reference and calibrated with demo_presses. Or
  /// loads an identical one from the cache: its measurements and files are the same, except the
  /// date of its calibration. Errors: a scene that is missing or wrong; those of
  /// install_reference() and calibrate_finger(); stopped.
  [[nodiscard]] static Result<ExperimentBench> make(const BenchOptions& options, const Job& job);
  /// A random finger from the seed of this one's options, in an adjacent folder, without a force
  /// model. Made at the first request. Errors: those of make().
  ///   number: from 1 on
  [[nodiscard]] Result<const ExperimentBench*> untrained_variant(int number) const;
  /// The same, trained on the forces of experiment_force (push_experiments.h).
  struct TrainedVariant;
  [[nodiscard]] Result<const TrainedVariant*> variant(int number) const;

  [[nodiscard]] const FingerSnapshot& finger() const { return *finger_; }
  [[nodiscard]] const ReferenceLibrary& library() const { return library_.value(); }
  /// The finger comes from the cache.
  [[nodiscard]] bool finger_was_cached() const { return finger_was_cached_; }
  /// Why the finger could not be cached.
  [[nodiscard]] const std::optional<Error>& cache_problem() const { return cache_problem_; }
  /// Trains the finger's force model with these pushes; later measurements use the model. Errors:
  /// those of train_finger_force().
  [[nodiscard]] Result<TrainedForce> learn_force(const ForceTable& table,
                                                 const ForceTraining& training);
  [[nodiscard]] const BenchOptions& options() const { return options_; }
  [[nodiscard]] const Job& job() const { return *job_; }
  /// The untouched finger in the recording's rest frame. Without its images.
  [[nodiscard]] const Truth& truth_at_rest() const { return truth_at_rest_; }

  /// A scene of the resources by its file's name without the ending, on this bench's finger.
  [[nodiscard]] Result<Plan> plan(const std::string& scene) const;
  /// The same with the finger of the file.
  [[nodiscard]] Result<Plan> plan_as_written(const std::string& scene) const;

  /// Receives every frame, in order.
  ///   which: index of the settings that the frame was measured with
  using Take =
      std::function<void(std::size_t which, const Truth& truth, const FrameResult& result)>;

  struct Measuring {
    std::vector<PipelineSettings> settings{PipelineSettings{}};
    TruthDetail truth = TruthDetail::kWithoutImages;
    /// Of a scene that names ambient, instead of its own; empty: the scene's value.
    std::optional<double> room_level;
  };
  /// Measures all frames of a scene, each by itself and with each of the settings. Returns the
  /// number of frames. Errors: those of plan() and Pipeline; stopped.
  [[nodiscard]] Result<int> measure(const std::string& scene,
                                    const Measuring& measuring,
                                    const Take& take) const;

  /// Images of the frames [first, end) as a source would deliver them.
  [[nodiscard]] std::vector<FramePtr> frames(const Plan& plan, int first, int end) const;

  /// Makes a finger from a recording in a folder of its own below that of the options: described as
  /// in its scene, with that recording as its reference, not calibrated.
  struct Recorded {
    Finger finger;
    std::filesystem::path folder;
    Truth truth_at_rest;  ///< without its images
    int rest_frame = 0;   ///< of the plan
  };
  [[nodiscard]] static Result<Recorded> record(const Plan& recording,
                                               const std::string& folder,
                                               const BenchOptions& options,
                                               const Job& job);

 private:
  ExperimentBench(BenchOptions options, const Job& job)
      : options_(std::move(options)), job_(&job) {}
  [[nodiscard]] Status make_finger(const Plan& recording);
  [[nodiscard]] Result<std::string> cache_name() const;
  /// True: the finger is restored from the cache.
  [[nodiscard]] bool restore_finger(const Plan& recording, const std::string& name);

  BenchOptions options_;
  const Job* job_;
  FingerPtr finger_;
  std::optional<ReferenceLibrary> library_;  // held, so that all pipelines share it
  Truth truth_at_rest_;
  int rest_frame_ = 0;  // of the recording's plan
  bool finger_was_cached_ = false;
  std::optional<Error> cache_problem_;
  // By number; used by one thread.
  mutable std::map<int, std::shared_ptr<const ExperimentBench>> untrained_variants_;
  mutable std::map<int, std::shared_ptr<const TrainedVariant>> variants_;
};

}  // namespace alltact
