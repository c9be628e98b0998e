// Recording frames as they come: on a thread of its own, whole whatever happens, and never losing
// one without saying so.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/recording/video_writer.h"
#include "core/result.h"
#include "core/settings.h"

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

/// The table that flags and dialogs are made from.
[[nodiscard]] const std::vector<Setting<RecorderSettings>>& recorder_settings();

/// What a recording has come to.
struct RecorderCounts {
  std::uint64_t recorded = 0;       ///< frames in the file
  std::uint64_t dropped = 0;        ///< frames that found the queue full
  std::uint64_t missing = 0;        ///< frames that never came: gaps in the source's sequence
  std::uint64_t waiting = 0;        ///< frames in the queue
  std::uint64_t bytes = 0;          ///< of the video
  std::uint64_t free_bytes = 0;     ///< left on its disk
  std::optional<VideoCodec> codec;  ///< known after the first frame
};

/// A recording under way: NAME.mkv and beside it NAME.frames.csv (see journal.h). It ends when
/// finish() is called, or by itself, whole, when the disk is nearly full, when the recording cannot
/// be written, or when it was removed behind our back (it is then put back where it was). A power
/// cut takes about its last second. Any thread may call any function, finish() once.
class Recorder {
 public:
  /// Makes the two files. `frames_per_s`: about how often frames come. `source`: told in the
  /// journal. Errors: the file exists, the folder cannot be written to, the disk has less than the
  /// reserve left.
  [[nodiscard]] static Result<std::unique_ptr<Recorder>> start(const std::filesystem::path& file,
                                                               const RecorderSettings& settings,
                                                               double frames_per_s,
                                                               std::string_view source);
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;
  ~Recorder();

  /// Puts a frame into the queue and returns at once. False: the queue is full and the frame is
  /// lost (counted, and told in the journal), or the recording has ended.
  bool add(FramePtr frame);
  /// Waits for room in the queue instead, for sources that can wait. False: the recording ended.
  bool add_waiting(FramePtr frame);

  [[nodiscard]] RecorderCounts counts() const;
  /// Why the recording ended by itself; nothing as long as it goes on.
  [[nodiscard]] std::optional<Error> problem() const;

  /// Writes what waits and completes the files. `why`: the last remark in the journal. `job` is
  /// told while a removed recording is put back, which takes as long as the disk needs to copy it,
  /// and may stop that. Error: problem(), or that the end could not be written; what was recorded
  /// is readable all the same.
  [[nodiscard]] Status finish(std::string_view why, const Job& job = Job());

 private:
  struct State;
  explicit Recorder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
