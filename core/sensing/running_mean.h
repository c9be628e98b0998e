// Mean of the last pictures of a source, for a finger that holds still.
#pragma once

#include <cstddef>
#include <deque>

#include <opencv2/core.hpp>

namespace alltact {

/// Its time does not grow with how many they are.
class RunningMean {
 public:
  /// Of the last `most` pictures, 1 (each as it is) to 256.
  explicit RunningMean(int most) : most_(static_cast<std::size_t>(most)) {}

  /// `grey`: CV_8UC1, not written to from now on. Mean, rounded, of it and those before it;
  /// pictures of another size are forgotten.
  [[nodiscard]] cv::Mat operator()(const cv::Mat& grey);

  /// The next picture is the first.
  void forget() { last_.clear(); }

 private:
  std::size_t most_;
  std::deque<cv::Mat> last_;
  cv::Mat sum_;  // of them, CV_16UC1
};

}  // namespace alltact
