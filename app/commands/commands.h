// The commands of `alltact`: options and function of each. One file each; the demonstration runs
// the same functions.
#pragma once

#include "app/console/console.h"
#include "calibration/checks/press_check.h"
#include "calibration/export/export_finger.h"
#include "calibration/force/collect_force.h"
#include "calibration/force/train_force.h"
#include "calibration/joint/calibrate.h"
#include "calibration/lens/calibrate_lens.h"
#include "calibration/reference/motion_coverage.h"
#include "calibration/reference/reference_recording.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/batch/parts.h"
#include "core/camera/camera.h"
#include "core/devices/hid_button.h"
#include "core/devices/open_gauge.h"
#include "core/devices/v4l2_camera.h"
#include "core/finger/finger_store.h"
#include "core/recording/recorder.h"
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
#include <Eigen/Core>
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

struct SimulateFitOptions {
  Path finger;
  std::vector<Path> presses;    ///< empty: those stored with the finger
  std::vector<Path> untouched;  ///< empty: the finger's own reference
  double ball_radius_mm = 0;    ///< 0: that of the finger's presses
  Path scene;                   ///< to be written
};
/// Writes the scene whose frames match a real finger's (twin.h).
Status run_simulate_fit(const SimulateFitOptions& options, Console& console);
/// Prints the time of every effect of the simulation on this computer.
Status run_simulate_costs(int frames, Console& console);
/// Lists the effects, or the parameters of one. Error: there is no such effect.
Status run_simulate_effects(const std::string& name, Console& console);

struct LensOptions {
  std::vector<Path> inputs;
  Board board;  ///< only columns, rows and square_mm; the rest is in the settings
  LensSettings settings;
  Orientation orientation = Orientation::kNone;
  std::optional<FlatPort> port;           ///< the finger's window, where the board had none
  std::optional<double> known_length_mm;  ///< on the finger, with `known_ends`
  std::vector<double> known_ends_px;      ///< u1 v1 u2 v2 in the image after orientation
  Path camera;
};
/// Calibrates a lens from images of a board and writes CAMERA.yaml.
Status run_lens(const LensOptions& options, Console& console);

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
  bool points = false;
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

/// Merges the parts of a reconstruction (parts.h).
Status run_merge(const std::vector<Path>& folders, Console& console);

struct ServeOptions {
  Path finger;
  std::vector<Path> inputs;
  std::optional<Path> socket;  ///< empty: the default one (stream_server.h)
  /// The settings to measure with, as the finger's folder has them now.
  std::function<Result<PipelineSettings>()> settings;
  bool schema = false;  ///< prints the format instead
};
/// Measures a live source and sends the results to other programs, until it ends or is stopped.
/// Errors: the socket is taken or others could reach it; the finger is not calibrated.
Status run_serve(const ServeOptions& options, Console& console);

/// The light that a recording is made with.
struct LightOptions {
  std::string device;  ///< empty: none is set
  std::string control;
  double brightness = 0;
};

struct RecordOptions {
  std::vector<Path> inputs;
  Path output;  ///< a video; or, with a button, the name pattern of images (png)
  std::optional<LearntButton> button;
  LightOptions light;
  RecorderSettings recorder;
  Pace pace = Pace::kRecorded;
  std::uint64_t seed = 1;
  int threads = 1;
  std::optional<std::uint64_t> frames;  ///< ends after so many
  std::optional<double> seconds;        ///< ends after so much recorded time
  GaugeChoice gauge;                    ///< read in parallel; none where its name is empty
};
/// Records a source until it ends or is stopped; with a button, between one press and the next, or
/// one image a press. Error: frames were lost on this computer, or could not be read; the recording
/// had to end; the button or the light is missing or not allowed.
Status run_record(const RecordOptions& options, Console& console);

/// Prints the grade of a finger's calibration, and its last checks. Error: it is not fit to use.
Status run_check(const Path& finger, Console& console);
/// Checks the calibration with new presses and stores the outcome. Error: calibrate again.
Status run_check_presses(const Path& folder, const PressInput& presses, const PressSet& press_set,
                         Console& console);
/// Compares images of the finger out of contact with its reference. Error: record that again.
Status run_check_reference(const Path& finger, const std::vector<Path>& images, Console& console);
/// Prints the accuracy of hard calculations on this computer (hard_cases.h). Error: one is out of
/// bounds.
Status run_check_numerics(Console& console);

struct ForceOptions {
  Path finger;
  std::vector<Path> tables;
  std::optional<ForceSplit> split;
  std::optional<ForceKind> kind;
  bool is_kind_given = false;  ///< else, with `again`, as before; kind is empty for "auto"
  std::optional<double> creep_s;
  bool again = false;  ///< with the finger's stored table, split, kind and creep
  bool undo = false;   ///< back to the model from before
  int threads = 1;
  std::vector<Path> recording;  ///< a table is made of it, and of:
  Path gauge, output;           ///< gauge: empty where it lies next to the recording
  GaugeFileOptions gauge_file;
  CollectOptions collect;
};
/// Trains a finger's force model, or collects a table for that.
Status run_force(const ForceOptions& options, Console& console);

struct ExportOptions {
  Path finger;
  Path folder;
  std::vector<ExportForm> forms;
};
/// Writes a finger's calibration for other programs.
Status run_export(const ExportOptions& options, Console& console);

struct GripperOptions {
  Path gripper;  ///< gripper.yaml or its folder
  std::optional<double> motor_turns;
  std::optional<double> motor_sd_turns;  ///< empty: gripper.yaml's
  std::optional<Path> motor_log;         ///< instead of motor_turns, with results
  std::vector<Path> results;             ///< none, or results.jsonl of the first and second finger
  double tolerance_ms = 20;
  Eigen::Vector3d up = {0, 0, -1};  ///< in the gripper's frame
};
/// Prints the reach of a gripper's linkages, its cameras' poses for a motor position, and the
/// object between the fingers from recordings of both. Error: out of reach; no frames that belong
/// together.
Status run_gripper(const GripperOptions& options, Console& console);

struct DemoOptions {
  Path folder;
  bool studio = false;  ///< the finger alone, and the Studio instead of this program
  std::uint64_t seed = 1;
  int threads = 1;
};
/// A full day of a simulated finger, with its measurements against the truth. With `studio` it
/// returns only where that cannot be opened.
Status run_demo(const DemoOptions& options, Console& console);

struct ExperimentsOptions {
  std::vector<std::string> names;  ///< none: all
  std::optional<Path> folder;  ///< for the fingers and experiments.json; empty: nothing is stored
  std::optional<Path> report;  ///< NAME.html; NAME.pdf goes next to it
  bool fresh = false;          ///< no finger of an earlier run, and none for a later one
  std::uint64_t seed = 1;
  int threads = 2;
};
/// Repeats the source paper's experiments in simulation and prints the results next to the paper's.
/// Error: no such experiment; one of them gave no figure.
Status run_experiments(const ExperimentsOptions& options, Console& console);

struct StudyCommandOptions {
  /// None: the demonstration's, simulated; with `simulating` the scene (none: demo_presses).
  std::vector<Path> fingers;
  std::optional<Path> folder;  ///< stores the study; empty: nothing is stored
  bool quick = false;          ///< one setting at a time, a few frames
  bool calibrating = false;    ///< instead: cost and benefit of presses, frames and methods
  bool simulating = false;     ///< instead: cost and influence of each effect of a scene
  bool scaling = false;        ///< instead: time and memory over the size of the measured data
  std::optional<double> max_time_ms, max_error_mm, position_mm;
  bool save = false;  ///< stores the presets with the finger
  std::string use;    ///< settings that the finger uses from now on (study.cpp); empty: as before
  std::uint64_t seed = 1;
  int threads = 1;
};
/// Prints the time and the accuracy of every setting. An incomplete study in the folder is
/// continued. Error: those of study_accuracy(); nothing is within the given limits.
Status run_study(const StudyCommandOptions& options, Console& console);

struct DevicesOptions {
  bool details = false;       ///< every format and control, too
  bool learn_button = false;  ///< waits for a button and prints how to recognise it
};
/// Lists cameras and HID devices, with the problems of those that cannot be used.
Status run_devices(const DevicesOptions& options, Console& console);

struct ThumbnailOptions {
  Path file, output;
  int size_px = 256;  ///< of the longer side
};
/// Writes a thumbnail of a depth map or a mesh for file managers (thumbnail.h).
Status run_thumbnail(const ThumbnailOptions& options, Console& console);

/// Set by the command that was chosen on the command line.
using Chosen = std::function<Status(Console&)>;

void add_new(CLI::App& program, Chosen& chosen);
void add_simulate(CLI::App& program, Chosen& chosen);
void add_lens(CLI::App& program, Chosen& chosen);
void add_reference(CLI::App& program, Chosen& chosen);
void add_calibrate(CLI::App& program, Chosen& chosen);
void add_reconstruct(CLI::App& program, Chosen& chosen);
void add_merge(CLI::App& program, Chosen& chosen);
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
