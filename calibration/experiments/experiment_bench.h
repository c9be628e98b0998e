// What all experiments of the source paper share here: a simulated finger, recorded and calibrated,
// and scenes of it that are measured frame by frame beside their truth.
#pragma once

#include "calibration/experiments/drawn_finger.h"
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
  /// For the fingers. What earlier experiments left there goes: experiment_finger,
  /// experiment_finger_1 and so on, and experiment_hd_finger.
  std::filesystem::path folder;
  std::uint64_t seed = 1;  ///< of everything random
  int threads = 1;         ///< that render; the figures are the same for any number
  DrawnFinger finger;      ///< the demonstration's
  /// Of a recording every n-th frame is made: fewer cost less, and leave poses without a near one.
  int recording_every = 1;
  std::string name = "experiment_finger";  ///< of the finger's folder below `folder`
  /// Where fingers are kept for the next run (kept_finger.h); absent: nowhere, and none is taken.
  std::optional<std::filesystem::path> cache;
};

class ExperimentBench {
 public:
  /// Makes the finger: recorded with the scene demo_reference and calibrated with demo_presses.
  /// Or takes the one that an earlier run made of the same and kept: what is measured with it is
  /// the same, its files are too, but for the date of its calibration.
  /// Errors: a scene that is missing or wrong; those of install_reference() and
  /// calibrate_finger(); stopped.
  [[nodiscard]] static Result<ExperimentBench> make(const BenchOptions& options, const Job& job);
  /// A finger drawn by the seed of this one's options, in a folder beside. Made when it is first
  /// asked for. Errors: those of make().
  ///   number: from 1 on
  [[nodiscard]] Result<const ExperimentBench*> drawn_untaught(int number) const;
  /// The same, after it has learnt forces by the pushes of experiment_force (push_experiments.h).
  struct Drawn;
  [[nodiscard]] Result<const Drawn*> drawn(int number) const;

  [[nodiscard]] const FingerSnapshot& finger() const { return *finger_; }
  [[nodiscard]] const ReferenceLibrary& library() const { return library_.value(); }
  /// An earlier run had made it.
  [[nodiscard]] bool finger_was_kept() const { return finger_was_kept_; }
  /// Why it could not be kept for the next run.
  [[nodiscard]] const std::optional<Error>& not_kept() const { return not_kept_; }
  /// Teaches the finger forces by these pushes; what it measures from then on it measures with
  /// them. Errors: those of give_force().
  [[nodiscard]] Result<TrainedForce> learn_force(const ForceTable& table,
                                                 const ForceTraining& training);
  [[nodiscard]] const BenchOptions& options() const { return options_; }
  [[nodiscard]] const Job& job() const { return *job_; }
  /// The untouched finger as it is in the frame of the recording that counts as rest.
  /// Without its pictures.
  [[nodiscard]] const Truth& truth_at_rest() const { return truth_at_rest_; }

  /// A scene of the resources by its file's name without the ending, on this bench's finger.
  [[nodiscard]] Result<Plan> plan(const std::string& scene) const;
  /// The same as the file has it.
  [[nodiscard]] Result<Plan> plan_as_written(const std::string& scene) const;

  /// Told of every frame, in order.
  ///   which: of the settings that the frame was measured with
  using Take =
      std::function<void(std::size_t which, const Truth& truth, const FrameResult& result)>;

  struct Measuring {
    std::vector<PipelineSettings> settings{PipelineSettings{}};
    TruthDetail truth = TruthDetail::kWithoutPictures;
    /// Of a scene that names ambient, instead of its own; absent: as it stands there.
    std::optional<double> room_level;
  };
  /// Measures all frames of a scene, each by itself and with each of the settings. Gives the number
  /// of frames. Errors: those of plan() and Pipeline; stopped.
  [[nodiscard]] Result<int> measure(const std::string& scene,
                                    const Measuring& measuring,
                                    const Take& take) const;

  /// Pictures of the frames [first, end) as a source would give them.
  [[nodiscard]] std::vector<FramePtr> frames(const Plan& plan, int first, int end) const;

  /// Makes a finger for a recording in a folder of its own below that of the options: described as
  /// its scene has it, with that recording as its reference, not calibrated.
  struct Recorded {
    Finger finger;
    std::filesystem::path folder;
    Truth truth_at_rest;  ///< without its pictures
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
  [[nodiscard]] Result<std::string> name_to_keep_by() const;
  /// True: an earlier run's finger is in its place.
  [[nodiscard]] bool take_finger(const Plan& recording, const std::string& name);

  BenchOptions options_;
  const Job* job_;
  FingerPtr finger_;
  std::optional<ReferenceLibrary> library_;  // held, so that every pipeline shares what was read
  Truth truth_at_rest_;
  int rest_frame_ = 0;  // of the recording's plan
  bool finger_was_kept_ = false;
  std::optional<Error> not_kept_;
  // By number; one thread asks.
  mutable std::map<int, std::shared_ptr<const ExperimentBench>> untaught_;
  mutable std::map<int, std::shared_ptr<const Drawn>> drawn_;
};

}  // namespace alltact
