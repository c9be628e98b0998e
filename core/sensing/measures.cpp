#include "core/sensing/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::optional<double> if_finite(float value) {
  if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// Samples from one pixel to another, at most a pixel apart.
std::vector<FaceSample> samples_between(const FrameResult& result,
                                        const Face& face,
                                        const cv::Mat& sd_mm,
                                        cv::Point2d from,
                                        cv::Point2d to) {
  const int steps = std::max(1, static_cast<int>(std::ceil(cv::norm(to - from))));
  std::vector<FaceSample> samples;
  for (int i = 0; i <= steps; ++i) {
    const double fraction = static_cast<double>(i) / steps;
    if (auto sample = sample_face(result, face, sd_mm, from + fraction * (to - from)))
      samples.push_back(*sample);
  }
  return samples;
}

}  // namespace

float bilinear_value(const cv::Mat& image, double u, double v) {
  const int left = static_cast<int>(std::floor(u)), upper = static_cast<int>(std::floor(v));
  const auto across = static_cast<float>(u - left), down = static_cast<float>(v - upper);
  const int right = across > 0 ? left + 1 : left, lower = down > 0 ? upper + 1 : upper;
  if (left < 0 || upper < 0 || right >= image.cols || lower >= image.rows)
    return std::numeric_limits<float>::quiet_NaN();
  const float* a = image.ptr<float>(upper);
  const float* b = image.ptr<float>(lower);
  return (1 - down) * ((1 - across) * a[left] + across * a[right]) +
         down * ((1 - across) * b[left] + across * b[right]);
}

std::optional<FaceSample> sample_face(const FrameResult& result,
                                      const Face& face,
                                      const cv::Mat& sd_mm,
                                      cv::Point2d pixel) {
  if (!result.shape || !result.depth) return std::nullopt;
  const int u = static_cast<int>(std::lround(pixel.x)), v = static_cast<int>(std::lround(pixel.y));
  const cv::Mat& depth = result.depth->depth_mm;
  if (u < 0 || v < 0 || u >= depth.cols || v >= depth.rows) return std::nullopt;
  const auto rows = result.shape->rows(u, 0);
  if (v < rows.first || v > rows.last) return std::nullopt;
  const auto local = result.shape->at(pixel.x, pixel.y);
  if (!local) return std::nullopt;
  FaceSample sample;
  sample.pixel = pixel;
  sample.untouched_mm = untouched_point_mm(*local, face.layer_mm, MappingAlong::kZ);
  sample.depth_mm = if_finite(bilinear_value(depth, pixel.x, pixel.y));
  if (!sd_mm.empty()) sample.sd_mm = if_finite(bilinear_value(sd_mm, pixel.x, pixel.y));
  sample.flag = result.depth->flags.at<std::uint8_t>(v, u);
  return sample;
}

Profile profile_between(const FrameResult& result,
                        const Face& face,
                        const cv::Mat& sd_mm,
                        cv::Point2d from,
                        cv::Point2d to) {
  Profile profile;
  double along = 0;
  const auto samples = samples_between(result, face, sd_mm, from, to);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (i > 0) along += (samples[i].untouched_mm - samples[i - 1].untouched_mm).norm();
    profile.pixels.push_back(samples[i].pixel);
    profile.along_mm.push_back(along);
    profile.depth_mm.push_back(samples[i].depth_mm.value_or(kNaN));
    profile.sd_mm.push_back(samples[i].sd_mm.value_or(kNaN));
  }
  return profile;
}

std::optional<Distance> distance_between(const FrameResult& result,
                                         const Face& face,
                                         cv::Point2d from,
                                         cv::Point2d to) {
  const auto first = sample_face(result, face, {}, from), last = sample_face(result, face, {}, to);
  if (!first || !last) return std::nullopt;
  Distance distance;
  distance.apart_mm = last->point_mm() - first->point_mm();
  distance.straight_mm = distance.apart_mm.norm();
  const auto samples = samples_between(result, face, {}, from, to);
  for (std::size_t i = 1; i < samples.size(); ++i)
    distance.along_face_mm += (samples[i].point_mm() - samples[i - 1].point_mm()).norm();
  return distance;
}

}  // namespace alltact
