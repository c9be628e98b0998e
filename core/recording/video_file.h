// Reads videos: any frame by its number, exactly as it was recorded.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>

namespace alltact {

/// An open video. Recordings of this program return the exact grey levels, JPEG packets, times and
/// sequence numbers (from their journal, see journal.h). Other videos are converted to grey (see
/// grey_of in libav.h), with times from the file. Not for several threads at once.
class VideoFile {
 public:
  /// Counts the frames (fast for Matroska, from its structure; other files are read through). First
  /// repairs an interrupted recording where possible (see repair_recording(); `job` gets the
  /// progress and may stop it); otherwise the existing part is read. Errors: cannot be opened,
  /// cannot be decoded, holds no frame.
  [[nodiscard]] static Result<VideoFile> open(const std::filesystem::path& file,
                                              const Job& job = Job());
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) noexcept;
  ~VideoFile();

  /// At least 1.
  [[nodiscard]] std::size_t frame_count() const;
  /// Frame `number` (below frame_count()), named frame_NNNNN, in display order. Sequential access
  /// is fastest. Error: it cannot be decoded; others may still be readable.
  [[nodiscard]] Result<FramePtr> frame(std::size_t number);
  /// Time of capture, as Frame::time_ns, without decoding.
  [[nodiscard]] std::int64_t time_ns(std::size_t number) const;
  /// Approximate rate of the frames, 1/s.
  [[nodiscard]] double frames_per_s() const;

 private:
  struct State;
  explicit VideoFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
