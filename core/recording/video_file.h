// Reading videos: any frame by its number, exactly as it was recorded.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"

#include <cstddef>
#include <filesystem>
#include <memory>

namespace alltact {

/// An open video. Recordings of this program come back with the exact grey levels, JPEG packets,
/// times and sequence numbers (from their journal, see journal.h) that went in; other videos as
/// grey (see grey_of in libav.h), their times from the file. Not for several threads at once.
class VideoFile {
 public:
  /// Counts the frames (quick for Matroska, whose structure tells; others are read through). A
  /// recording that was cut off is mended first where that can be (see mend.h; `job` is told and
  /// may stop it); where not, what is there is read as it is.
  /// Errors: cannot be opened, of a kind that cannot be decoded, holds no frame.
  [[nodiscard]] static Result<VideoFile> open(const std::filesystem::path& file,
                                              const Job& job = Job());
  VideoFile(VideoFile&&) noexcept;
  VideoFile& operator=(VideoFile&&) noexcept;
  ~VideoFile();

  /// At least 1.
  [[nodiscard]] std::size_t frame_count() const;
  /// Frame `number` (below frame_count()), named frame_NNNNN, in the order in which they are
  /// shown. One after the other is quickest. Error: it cannot be decoded; others still can.
  [[nodiscard]] Result<FramePtr> frame(std::size_t number);
  /// When it was captured, as its Frame::time_ns; nothing is decoded.
  [[nodiscard]] std::int64_t time_ns(std::size_t number) const;
  /// About how often frames come.
  [[nodiscard]] double frames_per_s() const;

 private:
  struct State;
  explicit VideoFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace alltact
