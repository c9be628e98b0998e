// One frame measured with two settings, and the difference of the depths.
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
  /// Depth of `other` minus that of `now`, mm, CV_32FC1, in the camera's image size at any
  /// resolution. NaN where either has none. Empty where one has no depth at all.
  cv::Mat difference_mm;
  /// Of absolute differences, where either depth is above 0.05 mm; empty: nothing presses.
  std::optional<double> median_mm, p95_mm;
  /// processor time of this frame, which each pipeline has seen once before
  double now_ms = 0, other_ms = 0;
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

/// Expands an image of a reduced frame: each value is repeated over the pixels that it covers, NaN
/// outside. Unchanged where nothing is reduced.
///   values: CV_32FC1
[[nodiscard]] cv::Mat at_full_size(const cv::Mat& values, int reduced_by, cv::Size full);

}  // namespace alltact
