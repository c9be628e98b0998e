#include "core/sensing/local_depth.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/depth_along_z.h"

#include <algorithm>
#include <cmath>
#include <limits>

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
ALLTACT_WIDE void select_row(const std::uint8_t* __restrict grey,
                             const float* __restrict reference,
                             const std::uint8_t* __restrict reference_valid,
                             const std::int32_t* __restrict first,
                             const std::int32_t* __restrict last,
                             std::int32_t row,
                             float darkest,
                             int width,
                             float* __restrict live_out,
                             float* __restrict reference_out,
                             std::uint8_t* __restrict flags) {
  constexpr float measured = kMeasured, off_face = kOffFace, dark = kTooDark, clipped = kSaturated;
  for (int u = 0; u < width; ++u) {
    const auto live = static_cast<float>(static_cast<std::int32_t>(grey[u]));
    const float ref = reference[u];
    // The last reason wins. Flags are small whole numbers in float and each pixel takes the same
    // steps, so that the loop runs in vectors.
    float flag = live >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = first[u] <= row ? flag : off_face;
    flag = row <= last[u] ? flag : off_face;
    flag = static_cast<std::int32_t>(reference_valid[u]) != 0 ? flag : off_face;
    flags[u] = static_cast<std::uint8_t>(static_cast<std::int32_t>(flag));
    live_out[u] = flag == measured ? live : 0.0F;
    reference_out[u] = flag == measured ? ref : 0.0F;
  }
}

ALLTACT_WIDE void scale_row(const float* __restrict in,
                            float weight,
                            int width,
                            float* __restrict out) {
  for (int u = 0; u < width; ++u) out[u] = weight * in[u];
}

ALLTACT_WIDE void add_pair(const float* __restrict a,
                           const float* __restrict b,
                           float weight,
                           int width,
                           float* __restrict out) {
  for (int u = 0; u < width; ++u) out[u] += weight * (a[u] + b[u]);
}

/// Separable smoothing of one row at a time; beyond the picture there is nothing (0).
class RowSmoother {
 public:
  RowSmoother(double sd_px, int width)
      : radius_(sd_px > 0.0 ? static_cast<int>(std::ceil(2.0 * sd_px)) : 0),
        width_(width),
        column_sums_(static_cast<std::size_t>(width + 2 * radius_), 0.0F),
        row_(static_cast<std::size_t>(width)),
        nothing_(static_cast<std::size_t>(width), 0.0F) {
    double sum = 0;
    for (int k = 0; k <= radius_; ++k) {
      const double z = radius_ > 0 ? k / sd_px : 0.0;
      weights_.push_back(static_cast<float>(std::exp(-0.5 * z * z)));
      sum += (k == 0 ? 1.0 : 2.0) * static_cast<double>(weights_.back());
    }
    for (float& weight : weights_) weight = static_cast<float>(static_cast<double>(weight) / sum);
  }

  /// The smoothed row; valid until the next call.
  const float* operator()(const cv::Mat& picture, int row) {
    const auto source = [&](int r) {
      return r >= 0 && r < picture.rows ? picture.ptr<float>(r) : nothing_.data();
    };
    float* middle = column_sums_.data() + radius_;
    scale_row(source(row), weights_[0], width_, middle);
    for (int k = 1; k <= radius_; ++k)
      add_pair(source(row - k), source(row + k), weight(k), width_, middle);
    scale_row(middle, weights_[0], width_, row_.data());
    for (int k = 1; k <= radius_; ++k)
      add_pair(middle - k, middle + k, weight(k), width_, row_.data());
    return row_.data();
  }

 private:
  [[nodiscard]] float weight(int k) const { return weights_[static_cast<std::size_t>(k)]; }

  int radius_, width_;
  std::vector<float> weights_;      // of the middle and of each distance from it
  std::vector<float> column_sums_;  // with radius_ zeros on both sides
  std::vector<float> row_, nothing_;
};

ALLTACT_WIDE void divide_row(const float* __restrict live,
                             const float* __restrict reference,
                             const std::uint8_t* __restrict flags,
                             int width,
                             float* __restrict x) {
  for (int u = 0; u < width; ++u) {
    const bool measured = flags[u] == kMeasured;
    const float below = measured ? reference[u] : 1.0F;
    const float value = (below - live[u]) / below;
    x[u] = measured ? value : kNaN;
  }
}

ALLTACT_WIDE void flag_row(const float* __restrict x,
                           float x_max,
                           int width,
                           std::uint8_t* __restrict flags) {
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
  result.x = cv::Mat(grey.size(), CV_32FC1);
  result.flags = cv::Mat(grey.size(), CV_8UC1);
  const Limits limits = face_limits(shape, options.edge_margin_px, grey.rows);
  for (int row = 0; row < grey.rows; ++row) {
    if (limits.rows.start <= row && row < limits.rows.end) continue;
    std::fill_n(result.x.ptr<float>(row), grey.cols, kNaN);
    std::fill_n(result.flags.ptr<std::uint8_t>(row), grey.cols, std::uint8_t{kOffFace});
  }
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
  RowSmoother smooth_live(options.smoothing_px, grey.cols);
  RowSmoother smooth_untouched(options.smoothing_px, grey.cols);
  for (int row = limits.rows.start; row < limits.rows.end; ++row) {
    const int local = row - limits.rows.start;
    divide_row(smooth_live(live, local),
               smooth_untouched(untouched, local),
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
