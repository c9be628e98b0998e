// Any frame of a recording by its number.
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

/// A video, or the pictures of a folder in name order. Of one thread.
class RecordedFrames {
 public:
  /// Errors: those of VideoFile::open and pictures_in.
  [[nodiscard]] static Result<RecordedFrames> open(const std::filesystem::path& input,
                                                   const Job& job);

  [[nodiscard]] std::size_t count() const;  ///< at least 1
  /// Error: it cannot be read; others still can.
  [[nodiscard]] Result<FramePtr> frame(std::size_t number);
  /// Of a video as it was recorded; pictures have no times and go by ten a second.
  [[nodiscard]] double frames_per_s() const;
  /// Of capture; null where they have none.
  [[nodiscard]] std::shared_ptr<const FrameTimes> times_ns() const;
  /// A frame follows the one before it in time.
  [[nodiscard]] bool is_continuous() const { return is_continuous_; }

 private:
  std::optional<VideoFile> video_;
  std::vector<std::filesystem::path> pictures_;
  bool is_continuous_ = true;
};

}  // namespace alltact
