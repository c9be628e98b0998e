#include "calibration/live/layers.h"

#include "core/grey_range.h"
#include "core/io/colour_map.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

constexpr double kFaint_mm = 0.05;  // nothing is coloured below: noise of an untouched face
constexpr double kFull_mm = 0.25;   // and fully from here on
constexpr double kStrongest = 0.85;
constexpr int kStripe_px = 6;

using Pixel = cv::Vec4b;  // blue, green, red, alpha

Pixel premultiplied(MapColour colour, double alpha) {
  const auto times = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(alpha * channel));
  };
  return {times(colour.blue), times(colour.green), times(colour.red), times(255)};
}

std::array<Pixel, 256> depth_table(double top_mm) {
  std::array<Pixel, 256> table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double part = static_cast<double>(i) / 255, depth_mm = part * top_mm;
    const double strength = std::clamp((depth_mm - kFaint_mm) / (kFull_mm - kFaint_mm), 0.0, 1.0);
    table[i] = premultiplied(viridis(part), kStrongest * strength);
  }
  return table;
}

struct Rows {
  int first, last;
};

Rows face_rows(const FrameResult& result, int u, int height) {
  if (!result.shape || u >= result.shape->width_px()) return {0, height - 1};
  const auto rows = result.shape->rows(u, 1.0);
  return {std::max(0, rows.first), std::min(height - 1, rows.last)};
}

/// What the measurement says of each pixel; where nothing was measured, what it would say of this
/// picture if it were the reference, too.
cv::Mat fault_flags(const cv::Mat& grey, const FrameResult& result) {
  if (result.depth) return result.depth->flags;
  if (result.difference) return result.difference->flags;
  const double dark_below = result.edges ? too_dark_below(result.edges->noise_sd) : kTooDarkBelow;
  cv::Mat flags(grey.size(), CV_8UC1, cv::Scalar(kOffFace));
  for (int u = 0; u < grey.cols; ++u) {
    const Rows rows = face_rows(result, u, grey.rows);
    for (int v = rows.first; v <= rows.last; ++v) {
      const int level = grey.at<std::uint8_t>(v, u);
      flags.at<std::uint8_t>(v, u) = level >= kClippedFrom ? kSaturated
                                     : level < dark_below  ? kTooDark
                                                           : kMeasured;
    }
  }
  return flags;
}

}  // namespace

cv::Mat depth_layer(const DepthMap& depth, double top_mm) {
  const auto table = depth_table(top_mm);
  const float scale = static_cast<float>(255 / top_mm);
  cv::Mat layer(depth.depth_mm.size(), CV_8UC4);
  for (int v = 0; v < layer.rows; ++v) {
    const float* d = depth.depth_mm.ptr<float>(v);
    auto* pixel = layer.ptr<Pixel>(v);
    for (int u = 0; u < layer.cols; ++u) {
      const float at = d[u] * scale;  // NaN is not above 0
      pixel[u] = at > 0 ? table[static_cast<std::size_t>(std::min(at, 255.0F))] : Pixel{};
    }
  }
  return layer;
}

cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result) {
  static const Pixel bright = premultiplied({230, 60, 40}, 1),
                     dark = premultiplied({60, 150, 255}, 1);
  const cv::Mat flags = fault_flags(grey, result);
  cv::Mat layer = cv::Mat::zeros(grey.size(), CV_8UC4);
  for (int v = 0; v < grey.rows; ++v) {
    const auto* flag = flags.ptr<std::uint8_t>(v);
    auto* pixel = layer.ptr<Pixel>(v);
    for (int u = 0; u < grey.cols; ++u) {
      if (flag[u] == kSaturated && (u - v + grey.rows * kStripe_px) % kStripe_px < kStripe_px / 2)
        pixel[u] = bright;
      if (flag[u] == kTooDark && (u + v) % kStripe_px < kStripe_px / 2) pixel[u] = dark;
    }
  }
  return layer;
}

}  // namespace alltact
