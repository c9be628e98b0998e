#include "core/sensing/local_depth.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/depth_along_z.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kCeiling = 250.0F;  // grey levels from here on are taken as clipped

/// First and last row of the face for every column, as the row loops need them.
struct Limits {
  std::vector<std::int32_t> first, last;
  cv::Range rows{0, 0};
};

Limits face_limits(const FaceShape& shape, double margin_px, int height) {
  Limits limits;
  const auto width = static_cast<std::size_t>(shape.width_px());
  limits.first.resize(width);
  limits.last.resize(width);
  limits.rows = {height, 0};
  for (std::size_t u = 0; u < width; ++u) {
    const auto [first, last] = shape.rows(static_cast<int>(u), margin_px);
    limits.first[u] = first;
    limits.last[u] = last;
    if (first > last) continue;
    limits.rows.start = std::min(limits.rows.start, first);
    limits.rows.end = std::max(limits.rows.end, last + 1);
  }
  if (limits.rows.end < limits.rows.start) limits.rows = {0, 0};
  return limits;
}

/// One row: what can be measured, and both brightnesses with 0 where nothing can.
ALLTACT_WIDE void select_row(const std::uint8_t* grey,
                             const float* reference,
                             const std::uint8_t* reference_valid,
                             const std::int32_t* first,
                             const std::int32_t* last,
                             std::int32_t row,
                             float darkest,
                             int width,
                             float* live_out,
                             float* reference_out,
                             std::uint8_t* flags) {
  for (int u = 0; u < width; ++u) {
    const float live = grey[u];
    const float ref = reference[u];
    const bool on_face = first[u] <= row && row <= last[u] && reference_valid[u] != 0;
    const bool dark = ref < darkest;
    const bool clipped = live >= kCeiling || ref >= kCeiling;
    const std::uint8_t flag = !on_face  ? kOffFace
                              : dark    ? kTooDark
                              : clipped ? kSaturated
                                        : kMeasured;
    const float weight = flag == kMeasured ? 1.0F : 0.0F;
    flags[u] = flag;
    live_out[u] = weight * live;
    reference_out[u] = weight * ref;
  }
}

ALLTACT_WIDE void divide_row(
    const float* live, const float* reference, const std::uint8_t* flags, int width, float* x) {
  for (int u = 0; u < width; ++u) {
    const bool measured = flags[u] == kMeasured;
    const float below = measured ? reference[u] : 1.0F;
    const float value = (below - live[u]) / below;
    x[u] = measured ? value : kNaN;
  }
}

ALLTACT_WIDE void flag_row(const float* x, float x_max, int width, std::uint8_t* flags) {
  for (int u = 0; u < width; ++u) flags[u] = x[u] > x_max ? std::uint8_t{kExtrapolated} : flags[u];
}

}  // namespace

Difference difference(const cv::Mat& grey,
                      const Reference& reference,
                      const FaceShape& shape,
                      const DifferenceOptions& options) {
  CV_Assert(grey.type() == CV_8UC1 && reference.grey.type() == CV_32FC1 &&
            grey.size() == reference.grey.size() && shape.width_px() == grey.cols);
  Difference result;
  result.x = cv::Mat(grey.size(), CV_32FC1, cv::Scalar(kNaN));
  result.flags = cv::Mat(grey.size(), CV_8UC1, cv::Scalar(kOffFace));
  const Limits limits = face_limits(shape, options.edge_margin_px, grey.rows);
  if (limits.rows.empty()) return result;

  const float darkest = static_cast<float>(std::max(8.0, 6.0 * options.noise_sd));
  cv::Mat live(limits.rows.size(), grey.cols, CV_32FC1);
  cv::Mat untouched(limits.rows.size(), grey.cols, CV_32FC1);
  for (int row = limits.rows.start; row < limits.rows.end; ++row) {
    const int local = row - limits.rows.start;
    select_row(grey.ptr<std::uint8_t>(row),
               reference.grey.ptr<float>(row),
               reference.valid.ptr<std::uint8_t>(row),
               limits.first.data(),
               limits.last.data(),
               row,
               darkest,
               grey.cols,
               live.ptr<float>(local),
               untouched.ptr<float>(local),
               result.flags.ptr<std::uint8_t>(row));
  }
  // Both pictures are smoothed alike before the division, with nothing from outside the face: the
  // weights of the missing neighbours cancel in the ratio, and dark pixels are not biased by it.
  if (options.smoothing_px > 0.0) {
    const int radius = static_cast<int>(std::ceil(3.0 * options.smoothing_px));
    const cv::Size kernel(2 * radius + 1, 2 * radius + 1);
    cv::GaussianBlur(live, live, kernel, options.smoothing_px, 0, cv::BORDER_CONSTANT);
    cv::GaussianBlur(untouched, untouched, kernel, options.smoothing_px, 0, cv::BORDER_CONSTANT);
  }
  for (int row = limits.rows.start; row < limits.rows.end; ++row) {
    const int local = row - limits.rows.start;
    divide_row(live.ptr<float>(local),
               untouched.ptr<float>(local),
               result.flags.ptr<std::uint8_t>(row),
               grey.cols,
               result.x.ptr<float>(row));
  }
  // One frame's noise and the reference's own, averaged over the kernel: sd / (2 sqrt(pi) s).
  const double averaging = options.smoothing_px > 0.0
                               ? std::min(1.0, 1.0 / (2.0 * std::sqrt(M_PI) * options.smoothing_px))
                               : 1.0;
  result.grey_sd = averaging * options.noise_sd * std::hypot(1.0, reference.noise_gain);
  return result;
}

DepthMap depth_map(const Difference& difference, const Mapping& mapping, const FaceShape& shape) {
  DepthMap map;
  map.depth_mm = cv::Mat(difference.x.size(), CV_32FC1);
  map.flags = difference.flags.clone();
  const int width = difference.x.cols;
  const float x_max = static_cast<float>(mapping.x_max());
  for (int row = 0; row < difference.x.rows; ++row) {
    const float* x = difference.x.ptr<float>(row);
    float* depth = map.depth_mm.ptr<float>(row);
    mapping.depths_mm(x, depth, width);
    flag_row(x, x_max, width, map.flags.ptr<std::uint8_t>(row));
  }
  if (mapping.parameters().along == MappingAlong::kNormal)
    map.depth_mm = depth_along_z(map.depth_mm, shape);
  return map;
}

}  // namespace alltact
