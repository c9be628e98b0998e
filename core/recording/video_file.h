// Reads, writes and repairs lossless videos: any frame by its number, exactly as it was recorded.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/image/frame.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

namespace alltact {

/// An open video, in any container and codec that libav reads. Recordings of this program return
/// the exact grey levels, JPEG packets, times and sequence numbers (from their journal, see
/// journal.h). Other videos are converted to grey (see grey_of in libav.h), with the times at which
/// they are shown. What their formats leave open follows from some of their frames. Not for several
/// threads at once.
class VideoFile {
 public:
  /// Counts the frames (fast for Matroska, from its structure; other files are read through, and
  /// decoded where only the decoder knows the order in which frames are shown). First
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
  /// The file, where VideoWriter wrote it as kMagicYuv: copy_frames() copies what this class reads.
  [[nodiscard]] std::optional<std::filesystem::path> lossless_file() const;
  /// What was assumed about a video of another program, and what makes it hard to measure; a
  /// sentence each.
  [[nodiscard]] const std::vector<Message>& remarks() const;

 private:
  struct State;
  explicit VideoFile(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Whether a file is a video by its content. Opens it, without counting its frames.
[[nodiscard]] bool contains_video(const std::filesystem::path& file);

// Lossless grey video, or the camera's own packets unchanged, in Matroska.

enum class VideoCodec {
  kAuto = 1,  ///< the camera's packets where it sends them, else kMagicYuv
  kMagicYuv,  ///< lossless, fast: writes 270 full HD frames a second on one core, reads a third of
              ///< that
  kFfv1,      ///< lossless, 8 to 16 % smaller, 8 times slower to write and 4 times slower to read
  kMjpeg,     ///< the camera's packets, unchanged
};

/// Returns "MagicYUV" and the like, for people.
[[nodiscard]] std::string_view to_string(VideoCodec codec);

/// Writes one video file. Each frame is in the file when add() returns, and stays readable after
/// any crash. Not for several threads at once.
class VideoWriter {
 public:
  /// Creates or overwrites the file for frames like `first`, which is not added yet.
  /// `frames_per_s`: approximate rate. Errors: the file cannot be written; kMjpeg for frames
  /// without packets; not 8-bit grey.
  [[nodiscard]] static Result<VideoWriter> create(const std::filesystem::path& file,
                                                  const Frame& first, VideoCodec codec,
                                                  double frames_per_s);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// Stores the frame's time in milliseconds after the first frame. A frame without a time, or not
  /// later than the last one, follows it by 1 / frames_per_s. Errors: another size than the first,
  /// no packet; or a failed write, after which the file takes no more but stays readable.
  [[nodiscard]] Status add(const Frame& frame);
  /// Writes the end of the file, and waits until everything is on the disk.
  [[nodiscard]] Status finish();

  [[nodiscard]] VideoCodec codec() const;     ///< never kAuto
  [[nodiscard]] std::uint64_t bytes() const;  ///< of the file so far
  /// Of the open file, for fstat and the like.
  [[nodiscard]] int descriptor() const;

 private:
  struct State;
  explicit VideoWriter(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

// Repair of recordings that a crash interrupted.

/// Adds index and length to a recording that was never finished (killed program, full disk), so
/// that any player can seek in it. Packets are copied unchanged to a temporary file in the same
/// folder. That file replaces the old one when it is complete and on the disk. A remark in the
/// journal reports frames that the journal has and the file lacks. Only files written by
/// VideoWriter are changed, and none that is being written. True: repaired; false: no repair was
/// necessary. Errors: it is being recorded right now, no space for a copy, folder read-only; the
/// recording stays readable.
[[nodiscard]] Result<bool> repair_recording(const std::filesystem::path& file, const Job& job);

/// Copies frames of a file written by VideoWriter to a new file, in order, without decoding: the
/// same bytes as if they were read and added one by one.
///   keep: by frame of `from`; at least one is chosen
/// Errors: `from` cannot be read, or has fewer frames; `to` cannot be written; stopped.
[[nodiscard]] Status copy_frames(const std::filesystem::path& from, const std::filesystem::path& to,
                                 const std::vector<char>& keep, const Job& job);

}  // namespace alltact
