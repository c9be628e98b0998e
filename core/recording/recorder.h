// Records frames on a thread of its own. What was recorded stays readable, but for about the last
// second before a power cut, and lost frames are reported.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/settings.h"
#include "core/image/frame.h"
#include "core/recording/video_file.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

struct RecorderSettings {
  VideoCodec codec = VideoCodec::kAuto;
  int queue_mb = 256;
  int reserve_mb = 256;
};

/// The table of settings for flags and dialogs.
[[nodiscard]] const std::vector<Setting<RecorderSettings>>& recorder_settings();

/// Progress of a recording.
struct RecorderCounts {
  std::uint64_t recorded = 0;       ///< frames in the file
  std::uint64_t dropped = 0;        ///< frames for which the queue was full
  std::uint64_t missing = 0;        ///< frames that never came: gaps in the source's sequence
  std::uint64_t waiting = 0;        ///< frames in the queue
  std::uint64_t bytes = 0;          ///< of the video
  std::uint64_t free_bytes = 0;     ///< free space of its disk
  std::optional<VideoCodec> codec;  ///< known after the first frame
};

/// A recording in progress: NAME.mkv and, next to it, NAME.frames.csv (see journal.h). It ends at
/// finish(), or by itself when the disk is nearly full, a write fails, or the file was removed (it
/// is then restored). The file is complete in each case. A power cut loses about the last second.
/// Any thread may call any function, finish() once.
class Recorder {
 public:
  /// Creates the two files. `frames_per_s`: approximate rate. `source`: written to the journal.
  /// Errors: the file exists, the folder is not writable, the disk has less free space than the
  /// reserve.
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& file,
                                                               const RecorderSettings& settings,
                                                               double frames_per_s,
                                                               std::string_view source);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();

  /// Appends a frame to the queue without waiting. False: the queue is full and the frame is lost
  /// (counted, and reported in the journal), or the recording has ended.
  bool add(FramePtr frame);
  /// Waits for space in the queue, for sources that can wait. False: the recording ended.
  bool add_waiting(FramePtr frame);

  [[nodiscard]] RecorderCounts counts() const;
  /// Why the recording ended by itself; empty while it runs.
  [[nodiscard]] std::optional<Error> problem() const;

  /// Writes the queue and completes the files. `why`: the last remark in the journal. `job` gets
  /// the progress of restoring a removed recording, which lasts as long as a copy, and may stop it.
  /// Error: problem(), or the end could not be written; recorded frames are readable in each case.
  [[nodiscard]] Status finish(std::string_view why, const Job& job = Job());

 private:
  struct State;
  explicit Recorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
