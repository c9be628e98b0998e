// The one owner of a finger's folder: reads it, and makes all changes to it.
#pragma once

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/finger/mapping.h"
#include "core/finger/press_set.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct ForceModel;

/// The file with a finger's measuring settings (calibration/finger/measuring_presets.h).
inline constexpr const char* kMeasuringFile = "measuring.yaml";

/// Content of a folder at one moment. The large reference recording is loaded on demand and shared:
/// ReferenceLibrary::load.
struct FingerSnapshot {
  std::filesystem::path folder;
  std::uint64_t revision = 0;  ///< increases with every change of finger.yaml that the store
                               ///< detects
  Finger finger;
  Camera camera;
  std::optional<Mapping> mapping;  ///< empty: the finger is not calibrated
  PressSet presses;
  std::optional<Error> presses_problem;     ///< why `presses` is empty although the file exists
  std::vector<Message> warnings;            ///< implausible values in finger.yaml
  std::shared_ptr<const ForceModel> force;  ///< null: the finger has no force model
  std::optional<Error> force_problem;       ///< why `force` is null although the finger names a
                                            ///< model
  int reduced_by = 1;                       ///< binning factor per side; 1: full resolution
  CameraParameters full_camera;             ///< camera of the full images, where they are reduced
  std::string measuring;                    ///< content of kMeasuringFile; empty: it does not exist

  /// The snapshot of a finger in memory, regardless of its folder's content. Errors: those of
  /// Camera::create and Mapping::create.
  [[nodiscard]] static Result<FingerSnapshot> of(const std::filesystem::path& folder,
                                                 Finger finger);
  /// The same finger, uncalibrated.
  [[nodiscard]] FingerSnapshot without_mapping() const;
};
using FingerPtr = std::shared_ptr<const FingerSnapshot>;

/// Any thread may call any function. Programs exclude each other like threads.
class FingerStore {
 public:
  /// Returns the store of a folder: one instance per program.
  [[nodiscard]] static std::shared_ptr<FingerStore> of(const std::filesystem::path& folder);
  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  /// The current content, read again only after a change by another program. Errors: those of
  /// Finger::load, Camera::create and Mapping::create.
  [[nodiscard]] Result<FingerPtr> snapshot();

  /// Reads finger.yaml, applies `change`, and writes it atomically. Threads and programs take
  /// turns, so that no concurrent change is lost. Returns the new content. `change` should only
  /// apply finished results, because others wait for it, up to ten seconds. Errors: those of
  /// snapshot(), `change` and Finger::save, with the file unchanged; another program holds the
  /// finger longer than that.
  [[nodiscard]] Result<FingerPtr> update(const std::function<Status(Finger&)>& change);

  /// Saves the notes about the presses, atomically.
  [[nodiscard]] Status save_presses(const PressSet& presses);

  /// Saves the result of `content` in kMeasuringFile, atomically; threads and programs take turns.
  /// Errors: those of `content` and snapshot(), with the file unchanged.
  [[nodiscard]] Status save_measuring(
      const std::function<Result<std::string>(const std::filesystem::path& folder)>& content);

  /// Locks a finger for exclusive work of minutes (calibrating, recording its reference); update()
  /// is possible meanwhile. Error: another one works on it, with its name.
  ///   doing: the activity, for the message to others ("calibrating")
  [[nodiscard]] Result<LockFile> lock_for_work(const std::string& doing);

  /// Called after every change, with the new and the old content, on the thread that made or
  /// detected it.
  using Listener = std::function<void(const FingerPtr& now, const FingerPtr& before)>;
  /// Listens until the returned handle is destroyed; the destruction waits for a running call.
  [[nodiscard]] std::shared_ptr<void> listen(Listener listener);

  explicit FingerStore(std::filesystem::path folder) : folder_(std::move(folder)) {}
  FingerStore(const FingerStore&) = delete;
  FingerStore& operator=(const FingerStore&) = delete;

 private:
  struct Listening;
  [[nodiscard]] Result<FingerPtr> read();
  void notify(const FingerPtr& now, const FingerPtr& before);

  std::filesystem::path folder_;
  std::mutex mutex_;
  FingerPtr last_;
  /// Identity of the files from which `last_` was read.
  std::string finger_written_, presses_written_, force_written_, measuring_written_;
  std::list<std::weak_ptr<Listening>> listening_;
};

/// The store's snapshot of a folder.
[[nodiscard]] Result<FingerPtr> open_finger(const std::filesystem::path& folder);

/// Copies an entry of the provenance from `from`, or removes it where that has none.
void copy_provenance(const Finger& from, const std::string& key, Finger& finger);

// A finger at reduced image resolution.

/// Converts all pixel coordinates (camera, markers at rest, positions for poses) to images that are
/// reduced by `by` pixels a side (camera.h). Returns the finger unchanged where `by` is 1,
/// it is reduced already, or its images would be smaller than any camera's (16 px).
[[nodiscard]] FingerSnapshot reduced_finger(const FingerSnapshot& finger, int by);

/// A raw image in the orientation of the finger's camera, reduced like the finger. Error: its size
/// differs from the finger's camera, see oriented_for().
[[nodiscard]] Result<cv::Mat> image_for(const FingerSnapshot& finger, const cv::Mat& raw,
                                        const Message& what, const Where& where,
                                        const Message& advice);

// Input for a new finger, from the window or the command line.

struct NewFinger {
  std::filesystem::path finger;  ///< the folder to make
  std::string name;              ///< empty: the folder's name
  std::filesystem::path camera;  ///< as load_camera() takes it
  FaceKind kind = FaceKind::kFinRay;
  double width_mm = 0;
  double layer_mm = 0;
  double plane_z_mm = 0;
  int per_row = 0;
  Polarity polarity = Polarity::kAuto;
  std::optional<RigidTransform> gripper_from_camera;
};

/// Makes a finger folder and returns the finger. Errors: there is a finger already; the camera file
/// or a value is wrong; the folder cannot be written. `camera_file`: may be null; what was read.
[[nodiscard]] Result<Finger> make_finger(const NewFinger& requested,
                                         CameraFile* camera_file = nullptr);

}  // namespace alltact
