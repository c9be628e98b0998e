// One frame measured with two settings, and by what their depths differ.
#pragma once

#include "core/finger/finger_store.h"
#include "core/frame.h"
#include "core/job.h"
#include "core/result.h"
#include "core/sensing/pipeline.h"

#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

struct ComparedFrame {
  FrameResult now, other;
  /// Depth of `other` less that of `now`, CV_32FC1, the camera's picture size whatever the
  /// resolution; NaN where one of them has none. Empty where one has no depth at all.
  cv::Mat difference_mm;
  /// Of absolute differences, where either depth is above 0.05 mm; absent: nothing presses.
  std::optional<double> median_mm, p95_mm;
  double now_ms = 0, other_ms = 0;  ///< processor time of this frame, which each saw before once
};

/// Used by one thread.
class ComparedSettings {
 public:
  /// Errors: those of Pipeline::create.
  [[nodiscard]] static Result<ComparedSettings> create(const FingerSnapshot& finger,
                                                       const PipelineSettings& now,
                                                       const PipelineSettings& other,
                                                       const Job& job);
  /// Error: the frame is not of the finger's size.
  [[nodiscard]] Result<ComparedFrame> operator()(const FramePtr& frame);

 private:
  ComparedSettings(Pipeline now, Pipeline other) : now_(std::move(now)), other_(std::move(other)) {}
  Pipeline now_, other_;
};

/// A picture of a reduced frame beside the pixels that it covers: each value at all of them, NaN
/// beyond. The same where nothing is reduced.
///   values: CV_32FC1
[[nodiscard]] cv::Mat at_whole_size(const cv::Mat& values, int reduced_by, cv::Size whole);

}  // namespace alltact
