// Runs a source for the window: opens, reads and records it on threads of its own.
#pragma once

#include "core/base/worker.h"
#include "core/devices/led_dimmer.h"
#include "core/devices/v4l2_camera.h"
#include "core/live/recording_feed.h"
#include "core/open/open_source.h"
#include "core/recording/recorder.h"
#include "core/sources/source.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// The function that opens a source: open_source, or a test's own.
using SourceOpener = std::function<Result<std::unique_ptr<Source>>(
    const std::vector<std::filesystem::path>& inputs, const SourceOptions& options)>;

enum class SourceState {
  kClosed = 1,
  kOpening,
  kRunning,
  kEnded,   ///< the last frame came
  kFailed,  ///< could not be opened: SourceStatus::problem
};

enum class RecordingState {
  kNone = 1,
  kRunning,
  kFinishing,  ///< the queue is being written
  kDone,       ///< also after a failed start or an early end: RecordingStatus::problem
};

struct RecordingStatus {
  RecordingState state = RecordingState::kNone;
  std::filesystem::path file;
  RecorderCounts counts;
  double seconds = 0;            ///< from the recorded frames' own times
  std::optional<Error> problem;  ///< why it could not begin, or ended by itself
};

struct SourceStatus {
  SourceState state = SourceState::kClosed;
  std::vector<std::filesystem::path> inputs;
  Message opening;               ///< progress of long opening, in words
  std::optional<Error> problem;  ///< why there are no frames now
  std::uint64_t delivered = 0;   ///< frames that came
  std::uint64_t missing = 0;     ///< frames that never came: gaps in the source's numbers
  /// Over the last second; while the source catches up, by the frames' own times.
  double frames_per_s = 0;
  bool is_catching_up = false;  ///< frames arrive faster than they were taken
  bool is_live = false, is_continuous = false;
  std::optional<CameraStatus> camera;
  std::vector<Message> remarks;  ///< Source::remarks() when it was opened
};

/// Any thread may call any function. Frames are published to `hub`, which must outlive this.
class SourceRunner {
 public:
  explicit SourceRunner(FrameHub& hub, SourceOpener opener = &alltact::open_source);
  /// Asks everything to stop and waits for it, at most `kStopTimeout`. finish_workers() waits for
  /// the rest.
  ~SourceRunner();
  SourceRunner(const SourceRunner&) = delete;
  SourceRunner& operator=(const SourceRunner&) = delete;
  static constexpr std::chrono::milliseconds kStopTimeout{700};

  /// Stops the current source and opens this one, at the recorded pace. Returns at once.
  void open(std::vector<std::filesystem::path> inputs, std::uint64_t seed = 1);
  void close();
  /// Does nothing while a recording runs. Returns at once; recording() shows the result. `feed`:
  /// gets every frame of the file, and its end in each case; may be null.
  void start_recording(const std::filesystem::path& file, const RecorderSettings& settings,
                       std::shared_ptr<RecordingFeed> feed = nullptr);
  void stop_recording();

  /// Sets the finger's light, which every frame records from now on. nullopt: unknown.
  void set_light(const std::optional<DimmerSetting>& light);

  [[nodiscard]] SourceStatus status() const;
  [[nodiscard]] RecordingStatus recording() const;
  /// The running camera; null where the source is none.
  [[nodiscard]] std::shared_ptr<V4l2Camera> camera() const;
  /// Age of a frame at `now_ns` of the monotonic clock; empty for images without times. Times of
  /// another clock are aligned by the frame of the last half second with the smallest delay.
  [[nodiscard]] std::optional<double> age_ms(const Frame& frame, std::int64_t now_ns) const;

 private:
  struct Run;
  FrameHub& hub_;
  SourceOpener opener_;
  mutable std::mutex mutex_;
  std::shared_ptr<Run> run_;
  Worker worker_;  // of run_
  std::optional<DimmerSetting> light_;
};

/// The monotonic clock by which cameras stamp their frames, ns.
[[nodiscard]] std::int64_t monotonic_ns();
/// The same in seconds.
[[nodiscard]] double monotonic_s();

}  // namespace alltact
