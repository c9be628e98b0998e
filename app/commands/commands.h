// The commands of `alltact`, a source each: add_NAME() registers a command. Options and functions
// are declared here only for the commands that the demonstration runs.
#pragma once

#include "app/console/console.h"
#include "calibration/joint/calibrate.h"
#include "calibration/presses/press_input.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/batch/parts.h"
#include "core/devices/v4l2_camera.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline_settings.h"
#include "core/sources/source.h"
#include "widgets/scene3d/scene_options.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <opencv2/core/utility.hpp>

namespace alltact {

using Path = std::filesystem::path;

/// Makes a finger folder. Error: there is a finger already.
Status run_new(const NewFinger& options, Console& console);

struct SimulateOptions {
  Path scene;
  Path folder;
  std::optional<int> frames;  ///< the first so many; empty: all
  std::uint64_t seed = 1;
  bool video = false;
  bool maps = false;     ///< also the truth of every pixel
  bool explain = false;  ///< explain the scene's steps, and render nothing
  int threads = 1;
  bool costs = false;  ///< run_simulate_costs() instead
  std::string effect;  ///< run_simulate_effects() of this one; empty: of all
};
/// Renders a scene and writes its truth next to it.
Status run_simulate(const SimulateOptions& options, Console& console);

struct ReferenceOptions {
  Path finger;
  std::vector<Path> inputs;
  ReferenceChoices choices;
};
/// Installs a reference recording in a finger.
Status run_reference(const ReferenceOptions& options, Console& console);

struct CalibrateOptions {
  Path finger;
  PressInput presses;
  double ball_radius_mm = 0;  ///< with `again` 0 for the same
  std::optional<Path> reference;
  std::string operator_name;  ///< stored with the calibration; empty: not given
  /// Applies the user's annotations of single presses; may be empty.
  std::function<void(PressSet&)> annotate_presses;
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  bool compare_methods = false;       ///< with others, which is for the joint one only
  bool again = false;                 ///< from the data stored with the finger, and with it:
  std::string date;                   ///< empty: now
  std::vector<std::string> included;  ///< names that are excluded no longer
  /// Applies the given settings to the stored ones; may be empty.
  std::function<void(CalibrationSettings&, PipelineSettings&)> change;
};
/// Learns a finger's depth mapping from ball presses.
Status run_calibrate(const CalibrateOptions& options, Console& console);

struct ReconstructOptions {
  Path finger;
  std::vector<Path> inputs;
  Path folder;
  bool depth = true, depth16 = false, depth_video = false, depth_sd = false, sd_causes = false,
       flags = true, limits = false;
  bool points = false, rectified = false;
  std::vector<std::string> surfaces;  ///< endings of write_surface, without the dot
  bool image = false;                 ///< of the face in 3D
  Viewpoint viewpoint = Viewpoint::kTilted;
  SceneOptions scene;
  int threads = 0;           ///< 0: all cores
  std::optional<Part> part;  ///< only this part of the frames, for run_merge()
  bool live = false;         ///< lines on standard output instead of files, until stopped
  bool as_paper = false;     ///< by the source paper's method, which has no settings
  PipelineSettings pipeline;
  /// Name of the finger's preset that gave `pipeline`; empty: none.
  std::string preset;
};
/// Measures depth in frames. Error at the end when any of them failed.
Status run_reconstruct(const ReconstructOptions& options, Console& console);

/// Set by the command that was chosen on the command line.
using Chosen = std::function<Status(Console&)>;

void add_new(CLI::App& program, Chosen& chosen);
void add_simulate(CLI::App& program, Chosen& chosen);
void add_lens(CLI::App& program, Chosen& chosen);
void add_reference(CLI::App& program, Chosen& chosen);
void add_calibrate(CLI::App& program, Chosen& chosen);
void add_reconstruct(CLI::App& program, Chosen& chosen);
void add_merge(CLI::App& program, Chosen& chosen);
void add_inspect(CLI::App& program, Chosen& chosen);
void add_serve(CLI::App& program, Chosen& chosen);
void add_record(CLI::App& program, Chosen& chosen);
void add_force(CLI::App& program, Chosen& chosen);
void add_check(CLI::App& program, Chosen& chosen);
void add_export(CLI::App& program, Chosen& chosen);
void add_gripper(CLI::App& program, Chosen& chosen);
void add_experiments(CLI::App& program, Chosen& chosen);
void add_study(CLI::App& program, Chosen& chosen);
void add_demo(CLI::App& program, Chosen& chosen);
void add_devices(CLI::App& program, Chosen& chosen);
void add_thumbnail(CLI::App& program, Chosen& chosen);

/// Warns of unusual entries in finger.yaml.
[[nodiscard]] Result<FingerPtr> open_finger(const Path& folder, Console& console);

// How many threads OpenCV may use.

inline void set_opencv_threads([[maybe_unused]] int threads) {
#if defined(__SANITIZE_THREAD__)
  cv::setNumThreads(1);  // it cannot see how TBB's threads hand memory over
#else
  cv::setNumThreads(threads);
#endif
}

// The settings that a command measures a finger with.

/// The finger's settings in use; where `preset` is not empty, those of that name. Errors: those of
/// presets_of_finger() and preset_settings().
[[nodiscard]] Result<PipelineSettings> stored_settings(const std::filesystem::path& finger,
                                                       const std::string& preset);

/// A mapping is valid for the settings that its presses were measured with.
void warn_of_other_settings(const PipelineSettings& stored, const PipelineSettings& requested,
                            Console& console);

/// Prints what was assumed about a source's frames, from the remark at index `from` on, and adds it
/// to the answer. Returns the number of all remarks: those on images come while these are read.
inline std::size_t report_remarks(const Source& source, Console& console, std::size_t from = 0) {
  const std::vector<Message> remarks = source.remarks();
  for (std::size_t i = from; i < remarks.size(); ++i) console.warn(remarks[i].english());
  if (!remarks.empty()) console.answer()["source_remarks"] = in_english(remarks);
  return remarks.size();
}

// Remarks of a camera while a command reads it.

/// Prints each remark once; does nothing for sources that are no camera.
class CameraRemarks {
 public:
  explicit CameraRemarks(const Source& source) {
    if (const auto* from_camera = dynamic_cast<const CameraSource*>(&source))
      camera_ = from_camera->shared_camera();
  }
  void report(Console& console) {
    if (!camera_) return;
    const CameraStatus status = camera_->status();
    const std::uint64_t first_stored = status.remarked - status.remarks.size();
    for (; reported_ < status.remarked; ++reported_)
      if (reported_ >= first_stored)
        console.warn(status.remarks[reported_ - first_stored].english());
  }

 private:
  std::shared_ptr<V4l2Camera> camera_;
  std::uint64_t reported_ = 0;
};

// A temporary folder for one run.

/// Removed when it is destroyed.
class ScopedFolder {
 public:
  /// Error: `cannot`, there is no room or no permission.
  static Result<ScopedFolder> make(const Message& cannot) {
    std::error_code failed;
    std::string path = (std::filesystem::temp_directory_path(failed) / "alltact-XXXXXX").string();
    if (failed || mkdtemp(path.data()) == nullptr)
      return Error{cannot, path, en::say("free space, or -o with a folder")};
    return ScopedFolder(path);
  }
  ScopedFolder(ScopedFolder&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  ScopedFolder& operator=(ScopedFolder&&) = delete;
  ~ScopedFolder() {
    std::error_code failed;
    if (!path_.empty()) std::filesystem::remove_all(path_, failed);
  }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  explicit ScopedFolder(std::filesystem::path path) : path_(std::move(path)) {}
  std::filesystem::path path_;
};

}  // namespace alltact
