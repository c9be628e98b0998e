// Common setup of the source paper's experiments: a simulated finger, recorded and calibrated, and
// scenes of it that are measured frame by frame with their ground truth.
#pragma once

#include "calibration/force/train_force.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"
#include "core/sensing/reference/reference_library.h"
#include "core/simulation/plan.h"
#include "core/simulation/scene.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

// Scenes on other fingers than the one they were written for.
//
// BACKGROUND
// A result on one finger may hold for that finger only. A scene describes a finger and what happens
// to it. The finger can be exchanged, so that the same experiment runs on other sizes, lenses,
// light, markers and stiffness.

/// A scene's description of its finger. Defaults: that of the demonstration.
struct FingerVariant {
  double width_mm = 24, layer_mm = 1.5;
  double x_mm = -25, z_mm = 28, incline_deg = 34, length_mm = 116;
  double focal_px = 523.9;  ///< in an image of 960 x 540
  double cx_px = 479.5, cy_px = 269.5;
  int per_row = 6;
  double dot_radius_mm = 1.5, setback_mm = 4, first = 0.1, last = 0.92, dot_albedo = 0.9;
  double scatter_per_mm = 0.6, side_albedo = 0.12;
  double light = 1;  ///< of all lamps, as a factor on the scene's value
  double shore_a = 40, wall_mm = 4, base_depth_mm = 34, tip_depth_mm = 12, coupling = 0.6;
  double layer_shore_a = 5;
  double scale = 1;                  ///< of the image: 0.5 is 480 x 270
  std::optional<double> room_level;  ///< of the effect ambient; empty: the scene's value

  /// A random finger, as another maker might cast it, in images of 960 x 540; the same for the same
  /// seed and number. Half that resolution costs a quarter of the time, but a ball at the tip
  /// covers ten pixels only. Its presses do not determine the layer's direction of thickness, and
  /// the wrong one moves every position by layer_mm tan(incline), a millimetre.
  [[nodiscard]] static FingerVariant draw(std::uint64_t seed, int number);
};

/// A scene of the resources with its finger exchanged: camera, face, pose and number of markers. Of
/// the effects markers, layer, sides, leds, body and push the parts that describe the finger
/// change, and the light of the room where it is given. Keys that a scene does not name are not
/// added. Errors: those of Scene::parse.
///   origin: the file, for errors; other files that it names are relative to it
[[nodiscard]] Result<Scene> scene_on_finger(std::string_view yaml,
                                            const std::filesystem::path& origin,
                                            const FingerVariant& finger);

/// The text of that scene.
[[nodiscard]] Result<std::string> scene_text_on_finger(std::string_view yaml,
                                                       const std::filesystem::path& origin,
                                                       const FingerVariant& finger);

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
  /// Cache of fingers for later runs; empty: no cache.
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
  /// The same, trained on the forces of experiment_force (force_experiments.h).
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
  [[nodiscard]] Result<int> measure(const std::string& scene, const Measuring& measuring,
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
  [[nodiscard]] static Result<Recorded> record(const Plan& recording, const std::string& folder,
                                               const BenchOptions& options, const Job& job);

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

// Cache of simulated fingers, recorded and calibrated, so that the next run of an experiment takes
// seconds.
//
// A folder of the cache holds one complete finger: it is filled in an adjacent folder and renamed.
// Its name encodes everything that the finger depends on, so that another program, scene or seed
// uses another folder. The folder holds a checksum of every file. A damaged finger is not loaded,
// and is replaced by the next one. Any number of programs may use the cache at once.

/// The name for a finger made by this program (its version and its code bytes) from these texts, in
/// this order.
[[nodiscard]] std::string cached_finger_name(const std::vector<std::string_view>& made_by);

/// Copies a cached finger to `to`, which must not exist, and returns the `note` stored with it.
/// nullopt: there is none, or it is damaged; then nothing exists at `to` either.
[[nodiscard]] std::optional<std::string> load_cached_finger(const std::filesystem::path& cache,
                                                            const std::string& name,
                                                            const std::filesystem::path& to);

/// Caches the files of a finger's folder. The eight newest fingers are retained. Errors: the cache
/// cannot be made or written.
[[nodiscard]] Status cache_finger(const std::filesystem::path& cache, const std::string& name,
                                  const std::filesystem::path& finger_folder,
                                  const std::string& note);

}  // namespace alltact
