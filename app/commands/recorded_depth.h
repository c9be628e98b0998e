// The depth of a full run as one file (depth_video.h), compressed by all threads and written by
// one.
#pragma once

#include "app/commands/commands.h"
#include "core/batch/batch.h"
#include "core/recording/depth_video.h"

#include <memory>
#include <mutex>
#include <optional>
#include <vector>

namespace alltact {

class RecordedDepth {
 public:
  /// In the options' folder; for a part, next to the part's results. Errors: DepthVideoWriter's.
  [[nodiscard]] static Result<std::unique_ptr<RecordedDepth>> create(
      const ReconstructOptions& options, cv::Size size, double frames_per_s);

  /// Adds the compressed depth frame to the line, and its index to the line's text. Any thread.
  [[nodiscard]] Status compress(const BatchFrame& frame, FrameLine& line);
  /// The next depth frame, in the frames' order, one thread at a time.
  [[nodiscard]] Status take(const FrameLine& line) { return video_.add(line.depth_packet); }
  [[nodiscard]] Status finish() { return video_.finish(); }

 private:
  RecordedDepth(cv::Size size, DepthVideoWriter video) : size_(size), video_(std::move(video)) {}

  cv::Size size_;
  DepthVideoWriter video_;
  std::mutex lock_;  // over:
  std::vector<DepthPackets> idle_;
};

}  // namespace alltact
