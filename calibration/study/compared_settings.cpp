#include "calibration/study/compared_settings.h"

#include "calibration/study/calibrating_bench.h"
#include "calibration/study/real_presses.h"
#include "calibration/study/truth_limits.h"

#include <cmath>
#include <limits>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

/// A frame's result and its processor time in a pipeline that has already seen the frame.
Result<FrameResult> timed(Pipeline& pipeline, const FramePtr& frame, double& milliseconds) {
  auto first = pipeline(frame);
  if (!first) return first;
  const double begin_s = thread_cpu_s();
  auto next = pipeline(frame);
  milliseconds = 1000 * (thread_cpu_s() - begin_s);
  return next ? std::move(first) : std::move(next);
}

}  // namespace

cv::Mat at_full_size(const cv::Mat& values, int reduced_by, cv::Size size) {
  if (reduced_by == 1) return values;
  cv::Mat full(size, CV_32FC1, cv::Scalar(std::numeric_limits<float>::quiet_NaN()));
  const cv::Size covered(values.cols * reduced_by, values.rows * reduced_by);
  cv::Mat part = full({0, 0, covered.width, covered.height});
  cv::resize(values, part, covered, 0, 0, cv::INTER_NEAREST);
  return full;
}

Result<ComparedSettings> ComparedSettings::create(const FingerSnapshot& finger,
                                                  const PipelineSettings& now,
                                                  const PipelineSettings& other,
                                                  const Job& job) {
  auto first = Pipeline::create(finger, now, job);
  if (!first) return first.error();
  auto second = Pipeline::create(finger, other, job);
  if (!second) return second.error();
  return ComparedSettings(std::move(first).value(), std::move(second).value());
}

Result<ComparedFrame> ComparedSettings::operator()(const FramePtr& frame) {
  ComparedFrame compared;
  auto now = timed(now_, frame, compared.now_ms);
  if (!now) return now.error();
  auto other = timed(other_, frame, compared.other_ms);
  if (!other) return other.error();
  compared.now = std::move(now).value();
  compared.other = std::move(other).value();
  if (!compared.now.depth || !compared.other.depth) return compared;
  const int by = compared.now.reduced_by;
  const cv::Mat& first = compared.now.depth->depth_mm;
  const cv::Size full = by == 1 ? first.size()
                        : compared.other.reduced_by == 1
                            ? compared.other.depth->depth_mm.size()
                            : cv::Size(first.cols * by, first.rows * by);
  const cv::Mat a = at_full_size(first, by, full),
                b = at_full_size(compared.other.depth->depth_mm, compared.other.reduced_by, full);
  compared.difference_mm = b - a;
  std::vector<float> pressed_mm;
  for (int v = 0; v < full.height; ++v)
    for (int u = 0; u < full.width; ++u) {
      const float off = compared.difference_mm.at<float>(v, u);
      const bool is_pressed = a.at<float>(v, u) > kPressedMm || b.at<float>(v, u) > kPressedMm;
      if (std::isfinite(off) && is_pressed) pressed_mm.push_back(std::abs(off));
    }
  if (const auto spread = spread_of_errors(pressed_mm)) {
    compared.median_mm = spread->median_mm;
    compared.p95_mm = spread->p95_mm;
  }
  return compared;
}

}  // namespace alltact
