// Mean of the last frames of a source, for a finger that holds still.
#pragma once

#include <cstddef>
#include <deque>

#include <opencv2/core.hpp>

namespace alltact {

/// The time of a call does not depend on the number of frames.
class RunningMean {
 public:
  /// Averages the last `max_frames` frames, 1 (no averaging) to 256.
  explicit RunningMean(int max_frames) : max_frames_(static_cast<std::size_t>(max_frames)) {}

  /// Returns the rounded mean of `grey` and the frames before it. `grey`: CV_8UC1, not written to
  /// from now on. Frames of another size are dropped.
  [[nodiscard]] cv::Mat operator()(const cv::Mat& grey);

  /// Drops all frames: the next one is the first.
  void forget() { last_.clear(); }

 private:
  std::size_t max_frames_;
  std::deque<cv::Mat> last_;
  cv::Mat sum_;  // of last_, CV_16UC1
};

}  // namespace alltact
