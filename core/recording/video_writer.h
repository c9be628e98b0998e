// Exact video: grey pictures without loss, or the camera's own packets untouched, in Matroska.
#pragma once

#include "core/frame.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace alltact {

enum class VideoCodec {
  kAuto = 1,  ///< the camera's packets where it sends such, else kMagicYuv
  kMagicYuv,  ///< lossless, quick: 270 full HD pictures a second on one core, read at a third of
              ///< that
  kFfv1,      ///< lossless, 8 to 16 % smaller, written 8 times and read 4 times slower
  kMjpeg,     ///< the camera's packets, untouched
};

/// "MagicYUV", for people.
[[nodiscard]] std::string_view to_string(VideoCodec codec);

/// Writes one video file. Each frame lies in the file, readable whatever happens then, when add()
/// returns. Not for several threads at once.
class VideoWriter {
 public:
  /// Makes the file (what was in it is gone) for frames like `first`, which is not yet added.
  /// `frames_per_s`: how often frames come, about.
  /// Errors: the file cannot be written; kMjpeg for frames without packets; not 8-bit grey.
  [[nodiscard]] static Result<VideoWriter> create(const std::filesystem::path& file,
                                                  const Frame& first,
                                                  VideoCodec codec,
                                                  double frames_per_s);
  VideoWriter(VideoWriter&&) noexcept;
  VideoWriter& operator=(VideoWriter&&) noexcept;
  ~VideoWriter();

  /// The frame's time is kept to the millisecond, counted from the first frame; a frame whose time
  /// is none or not after the last one's comes 1 / frames_per_s behind it.
  /// Errors: another size than the first, no packet; or it could not be written, and then the file
  /// takes no more but everything before stays readable.
  [[nodiscard]] Status add(const Frame& frame);
  /// Writes what makes the file complete, and waits until all is on the disk.
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

}  // namespace alltact
