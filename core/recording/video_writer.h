// Lossless grey video, or the camera's own packets unchanged, in Matroska.
#pragma once

#include "core/frame.h"
#include "core/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string_view>

namespace alltact {

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
                                                  const Frame& first,
                                                  VideoCodec codec,
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

}  // namespace alltact
