#include "calibration/live/layers.h"

#include "core/grey_range.h"
#include "core/io/colour_map.h"
#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace alltact {
namespace {

constexpr double kFaint_mm = 0.05;  // smaller depths have no colour: noise of an untouched face
constexpr double kFull_mm = 0.25;   // full colour from here on
constexpr double kStrongest = 0.85;
constexpr int kStripe_px = 6;

using Pixel = cv::Vec4b;                              // blue, green, red, alpha
using DepthColours = std::array<std::uint32_t, 256>;  // the same, as one number

Pixel premultiplied(MapColour colour, double alpha) {
  const auto times = [&](std::uint8_t channel) {
    return static_cast<std::uint8_t>(std::lround(alpha * channel));
  };
  return {times(colour.blue), times(colour.green), times(colour.red), times(255)};
}

/// From -kBulgeFraction to 1 of the top in even steps; zero is step kZeroStep.
constexpr float kZeroStep = static_cast<float>(255 * kBulgeFraction / (1 + kBulgeFraction));

DepthColours depth_colours(double top_mm) {
  DepthColours table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const double part = (1 + kBulgeFraction) * static_cast<double>(i) / 255 - kBulgeFraction;
    const double strength =
        std::clamp((std::abs(part * top_mm) - kFaint_mm) / (kFull_mm - kFaint_mm), 0.0, 1.0);
    table[i] =
        std::bit_cast<std::uint32_t>(premultiplied(depth_colour(part), kStrongest * strength).val);
  }
  return table;
}

/// Whether any of `count` depths has a colour; NaN has none.
ALLTACT_WIDE bool has_colour(const float* depth_mm, int count) {
  constexpr auto faint = static_cast<float>(kFaint_mm);
  std::int32_t any = 0;
  for (int u = 0; u < count; ++u) any |= std::abs(depth_mm[u]) > faint ? 1 : 0;
  return any != 0;
}

void colour_part(const float* depth_mm,
                 float steps_per_mm,
                 int count,
                 const DepthColours& colours,
                 std::uint32_t* pixels) {
  for (int u = 0; u < count; ++u) {
    const float at = depth_mm[u] * steps_per_mm + kZeroStep;
    pixels[u] =
        std::isfinite(at) ? colours[static_cast<std::size_t>(std::clamp(at, 0.0F, 255.0F))] : 0;
  }
}

struct Rows {
  int first, last;
};

Rows face_rows(const FrameResult& result, int u, int height) {
  if (!result.shape || u >= result.shape->width_px()) return {0, height - 1};
  const auto rows = result.shape->rows(u, 1.0);
  return {std::max(0, rows.first), std::min(height - 1, rows.last)};
}

/// Flags of each pixel; without a measurement those that the image itself implies, as live image
/// and as reference.
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

PartLayer depth_layer(const DepthMap& depth, double top_mm) {
  constexpr int kPart = 128;  // columns of a row, few of which show a colour
  const cv::Mat& map = depth.depth_mm;
  std::vector<cv::Rect> parts;
  cv::Rect all;
  for (int v = 0; v < map.rows; ++v)
    for (int u = 0; u < map.cols; u += kPart) {
      const cv::Rect part(u, v, std::min(kPart, map.cols - u), 1);
      if (!has_colour(map.ptr<float>(v) + u, part.width)) continue;
      all = parts.empty() ? part : all | part;
      parts.push_back(part);
    }
  if (parts.empty()) return {};
  const DepthColours colours = depth_colours(top_mm);
  const float scale = static_cast<float>(255 / ((1 + kBulgeFraction) * top_mm));
  PartLayer layer{cv::Mat::zeros(all.size(), CV_8UC4), all.tl()};
  for (const cv::Rect& part : parts)
    colour_part(map.ptr<float>(part.y) + part.x,
                scale,
                part.width,
                colours,
                layer.pixels.ptr<std::uint32_t>(part.y - all.y) + (part.x - all.x));
  return layer;
}

cv::Mat faults_layer(const cv::Mat& grey, const FrameResult& result) {
  static const Pixel bright = premultiplied({230, 60, 40}, 1),
                     dark = premultiplied({60, 150, 255}, 1),
                     white = premultiplied({255, 255, 255}, 1);
  const cv::Mat flags = fault_flags(grey, result);
  cv::Mat layer = cv::Mat::zeros(grey.size(), CV_8UC4);
  for (int v = 0; v < grey.rows; ++v) {
    const auto* flag = flags.ptr<std::uint8_t>(v);
    auto* pixel = layer.ptr<Pixel>(v);
    for (int u = 0; u < grey.cols; ++u) {
      if (flag[u] == kSaturated && (u - v + grey.rows * kStripe_px) % kStripe_px < kStripe_px / 2)
        pixel[u] = bright;
      if (is_at_limit(flag[u]) && v % kStripe_px < kStripe_px / 3) pixel[u] = white;
      if (flag[u] == kTooDark && (u + v) % kStripe_px < kStripe_px / 2) pixel[u] = dark;
    }
  }
  return layer;
}

}  // namespace alltact
