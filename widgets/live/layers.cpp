#include "core/io/colour_map.h"
#include "widgets/live/finger_watcher.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {
namespace {

constexpr double kFaint_mm = 0.05;  // nothing is coloured below: noise of an untouched face
constexpr double kFull_mm = 0.25;   // and fully from here on
constexpr double kStrongest = 0.85;
constexpr std::uint8_t kClipped = 250, kDark = 4;  // grey levels that cannot be measured
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
  cv::Mat layer = cv::Mat::zeros(grey.size(), CV_8UC4);
  for (int u = 0; u < grey.cols; ++u) {
    const Rows rows = face_rows(result, u, grey.rows);
    for (int v = rows.first; v <= rows.last; ++v) {
      const std::uint8_t level = grey.at<std::uint8_t>(v, u);
      if (level >= kClipped && (u - v + grey.rows * kStripe_px) % kStripe_px < kStripe_px / 2)
        layer.at<Pixel>(v, u) = bright;
      if (level <= kDark && (u + v) % kStripe_px < kStripe_px / 2) layer.at<Pixel>(v, u) = dark;
    }
  }
  return layer;
}

}  // namespace alltact
