// Random access to the frames of a recording.
#pragma once

#include "core/frame.h"
#include "core/job.h"
#include "core/recording/time_match.h"
#include "core/recording/video_file.h"
#include "core/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

/// A video, or the images of a folder in name order. One thread.
class RecordedFrames {
 public:
  /// Errors: those of VideoFile::open and images_in.
  [[nodiscard]] static Result<RecordedFrames> open(const std::filesystem::path& input,
                                                   const Job& job);

  [[nodiscard]] std::size_t count() const;  ///< at least 1
  /// Error: this frame cannot be read; others may still be readable.
  [[nodiscard]] Result<FramePtr> frame(std::size_t number);
  /// The recorded rate of a video; 10 per second for images, which have no times.
  [[nodiscard]] double frames_per_s() const;
  /// Times of capture, ns; null where the frames have none.
  [[nodiscard]] std::shared_ptr<const FrameTimes> times_ns() const;
  /// True when each frame follows the one before it in time.
  [[nodiscard]] bool is_continuous() const { return is_continuous_; }

 private:
  std::optional<VideoFile> video_;
  std::vector<std::filesystem::path> images_;
  bool is_continuous_ = true;
};

}  // namespace alltact
