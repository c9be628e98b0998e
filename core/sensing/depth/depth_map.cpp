#include "core/sensing/depth/depth_map.h"

#include "core/image/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/numerics/image_noise.h"
#include "core/numerics/median.h"
#include "core/numerics/vector_loops.h"
#include "core/sensing/depth/light_spread.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <limits>
#include <numeric>
#include <span>
#include <vector>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

// Loops over one pixel row from brightness to differences and flags.

constexpr float kNoDifference = std::numeric_limits<float>::quiet_NaN();
constexpr std::int16_t kCeiling = kClippedFrom * kGreySteps;

/// Converts both brightnesses of a row to steps (image_warp.h). True when every pixel of it can be
/// measured, as in nearly all rows. darkest: minimum of the reference, in steps.
ALLTACT_WIDE bool copy_row(const std::uint8_t* __restrict grey,
                           const std::int16_t* __restrict reference, std::int16_t darkest,
                           int count, std::int16_t* __restrict live_out,
                           std::int16_t* __restrict reference_out) {
  // By lane of a block; reduced once at the end, not in every block.
  std::array<std::int16_t, kBlock> brightest{}, darkest_seen;
  darkest_seen.fill(kCeiling);
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const auto live = static_cast<std::int16_t>(grey[u] * kGreySteps);
          const std::int16_t ref = reference[u];
          live_out[u] = live;
          reference_out[u] = ref;
          const std::int16_t brighter = live > ref ? live : ref;
          std::int16_t& max_value = brightest[static_cast<std::size_t>(k)];
          std::int16_t& min_value = darkest_seen[static_cast<std::size_t>(k)];
          max_value = brighter > max_value ? brighter : max_value;
          min_value = ref < min_value ? ref : min_value;
        }
      });
  return max_of(brightest) < kCeiling && min_of(darkest_seen) >= darkest;
}

/// Flags each pixel of a copied row that cannot be measured (depth_map.h), and sets both
/// brightnesses to 0 there.
ALLTACT_WIDE void flag_unmeasurable_row(std::int16_t darkest, int count,
                                        std::int16_t* __restrict live,
                                        std::int16_t* __restrict reference,
                                        std::uint8_t* __restrict flags) {
  constexpr std::int16_t measured = kMeasured, unknown = kNoReference, dark = kTooDark,
                         clipped = kSaturated;
  for (int u = 0; u < count; ++u) {
    const std::int16_t ref = reference[u], now = live[u];
    // The last reason wins; each pixel takes the same steps, so that the loop is vectorised.
    std::int16_t flag = now >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = ref == kNoGrey ? unknown : flag;
    // A mask: a conditional would become a branch.
    const auto mask = static_cast<std::int16_t>(-static_cast<std::int16_t>(flag == measured));
    flags[u] = static_cast<std::uint8_t>(flag);
    live[u] = static_cast<std::int16_t>(now & mask);
    reference[u] = static_cast<std::int16_t>(ref & mask);
  }
}

constexpr float kMinKernelPart = 0.2F;  // of the kernel: 0.3 is left in a corner of the face

constexpr std::array<float, kBlock> kBlockIndices = [] {
  std::array<float, kBlock> indices{};
  for (std::size_t k = 0; k < indices.size(); ++k) indices[k] = static_cast<float>(k);
  return indices;
}();

/// A smoothed row, its smoothed reference, and the reference before smoothing.
struct SmoothRow {
  const std::int16_t *live, *reference, *raw;
};

/// Fast path of divide_row() for rows without flags. Returns false where a pixel needs a flag,
/// which few rows do.
ALLTACT_WIDE bool divide_plain_row(const SmoothRow& row, const std::array<float, 3>& light,
                                   int first_column, float x_max, int count, float* __restrict x) {
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  std::array<std::int32_t, kBlock> special{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        for (int k = 0; k < size; ++k) {
          const int u = first + k;
          const float column = begin + kBlockIndices[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto here = static_cast<float>(from.raw[u]);
          const auto below = static_cast<float>(from.reference[u]);
          const float value = (below - correction * static_cast<float>(from.live[u])) / below;
          x[u] = value;
          const std::int32_t thin = below > kMinKernelPart * here ? 0 : 1;
          const std::int32_t beyond = value <= x_max ? 0 : 1;
          special[static_cast<std::size_t>(k)] |= thin | beyond;
        }
      });
  return max_of(special) == 0;
}

/// x = (reference - q live) / reference; NaN where flags require it. `light`: q in powers of the
/// column; the row's first column is first_column. Between pixels that could not be
/// measured hardly any of the kernel is left, and its outer weights are negative. Such a pixel
/// takes the reason of its neighbours: dark or clipped, whichever level is nearer. Measured values
/// beyond x_max are flagged.
ALLTACT_WIDE void divide_row(const SmoothRow& row, std::uint8_t* __restrict flags,
                             const std::array<float, 3>& light, int first_column, float x_max,
                             int count, float* __restrict x) {
  constexpr float measured = kMeasured, clipped = kSaturated, dark = kTooDark,
                  extrapolated = kExtrapolated;
  constexpr float kMiddle = 0.5F * kCeiling;
  const SmoothRow from = row;
  const float constant = light[0], slope = light[1], bow = light[2];
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        const auto begin = static_cast<float>(first_column + first);
        // In three loops: in one the compiler would branch for each pixel.
        std::array<float, kBlock> reason, values;
        for (int k = 0; k < size; ++k) {
          const auto before = static_cast<float>(static_cast<std::int32_t>(flags[first + k]));
          // the row may be divided twice
          const float flag = before == extrapolated ? measured : before;
          const auto here = static_cast<float>(from.raw[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float thin = here > kMiddle ? clipped : dark;
          const float left = smooth > kMinKernelPart * here ? measured : thin;
          reason[static_cast<std::size_t>(k)] = flag == measured ? left : flag;
        }
        for (int k = 0; k < size; ++k) {
          const float column = begin + kBlockIndices[static_cast<std::size_t>(k)];
          const float correction = constant + column * (slope + column * bow);
          const auto live = static_cast<float>(from.live[first + k]);
          const auto smooth = static_cast<float>(from.reference[first + k]);
          const float value = (smooth - correction * live) / smooth;
          values[static_cast<std::size_t>(k)] =
              reason[static_cast<std::size_t>(k)] == measured ? value : kNoDifference;
        }
        for (int k = 0; k < size; ++k) {
          const float value = values[static_cast<std::size_t>(k)];
          const float final = value > x_max ? extrapolated : reason[static_cast<std::size_t>(k)];
          x[first + k] = value;
          flags[first + k] = static_cast<std::uint8_t>(static_cast<std::int32_t>(final));
        }
      });
}

/// Flags values beyond x_max, as divide_row() does.
ALLTACT_WIDE void flag_row(const float* __restrict x, float x_max, int count,
                           std::uint8_t* __restrict flags) {
  constexpr float beyond = kExtrapolated;
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        for (int u = first; u < first + size; ++u) {
          const auto flag = static_cast<float>(static_cast<std::int32_t>(flags[u]));
          flags[u] =
              static_cast<std::uint8_t>(static_cast<std::int32_t>(x[u] > x_max ? beyond : flag));
        }
      });
}

/// Clamps depths to the layer's thickness, with their sign, and flags them as kBeyondLayer or
/// kBulgeLimit.
ALLTACT_WIDE void clamp_row(const float* __restrict max_mm, int count, float* __restrict depth_mm,
                            std::uint8_t* __restrict flags) {
  std::array<std::int32_t, kBlock> deeper{};
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        for (int k = 0; k < size; ++k)
          deeper[static_cast<std::size_t>(k)] |=
              std::abs(depth_mm[first + k]) > max_mm[first + k] ? 1 : 0;
      });
  if (max_of(deeper) == 0) return;  // true for nearly all rows
  for (int u = 0; u < count; ++u) {
    const float max_value = max_mm[u];
    if (!(std::abs(depth_mm[u]) > max_value)) continue;
    flags[u] = depth_mm[u] > 0.0F ? kBeyondLayer : kBulgeLimit;
    depth_mm[u] = std::copysign(max_value, depth_mm[u]);
  }
}

/// Greatest possible indentation by column, in the direction of the mapping's depth.
std::vector<float> layer_by_column(const MappingParameters& mapping, const FaceShape& shape) {
  constexpr float kMaxPerNormal = 3.8637033F;  // 1 / cos of 75 degrees
  const auto layer_mm = static_cast<float>(shape.face().layer_mm);
  const auto width = static_cast<std::size_t>(shape.width_px());
  if (mapping.along == MappingAlong::kNormal) return std::vector<float>(width, layer_mm);
  std::vector<float> max_mm = shape.along_z_per_normal();
  for (float& limit : max_mm) limit = layer_mm * std::min(limit, kMaxPerNormal);
  return max_mm;
}

/// Pixels outside of the face's runs have no measurement.
template <class Value, class Clear>
void clear_outside(std::span<const FaceRun> runs, int width, Value* values, Clear clear) {
  int done = 0;
  for (const FaceRun& run : runs) {
    clear(values + done, run.first - done);
    done = run.end;
  }
  clear(values + done, width - done);
}

void fill_off_face(std::uint8_t* flags, int count) {
  std::memset(flags, kOffFace, static_cast<std::size_t>(count));
}

/// Computes a depth map row by row from rows of differences.
class DepthMapper {
 public:
  DepthMapper(const Mapping& mapping, const FaceShape& shape, const FaceRuns& face, DepthMap& map)
      : mapping_(mapping),
        shape_(shape),
        face_(face),
        map_(map),
        scale_(mapping.parameters(), shape),
        max_mm_(layer_by_column(mapping.parameters(), shape)),
        cells_(map.depth_mm.size()) {}

  /// Takes rows in order; depths beyond the layer are flagged.
  void operator()(int row, const float* x) {
    float* depth = map_.depth_mm.ptr<float>(row);
    auto* flags = map_.flags.ptr<std::uint8_t>(row);
    const auto runs = face_.of_row(row);
    for (const FaceRun& run : runs) {
      mapping_.depths_mm(x + run.first, depth + run.first, run.size());
      if (!scale_.is_one()) scale_.scale(row, run.first, run.size(), depth + run.first);
      clamp_row(max_mm_.data() + run.first, run.size(), depth + run.first, flags + run.first);
    }
    clear_outside(runs, map_.depth_mm.cols, depth, fill_nan);
    cells_.add_row(row, runs, depth);
  }

  void finish() {
    map_.cells_mm = cells_.mean_mm();
    if (mapping_.parameters().along != MappingAlong::kNormal) return;
    map_.depth_mm = depth_along_z(map_.depth_mm, map_.cells_mm, shape_, map_.flags);
    map_.cells_mm = depth_cells(map_.depth_mm);
  }

 private:
  const Mapping& mapping_;
  const FaceShape& shape_;
  const FaceRuns& face_;
  DepthMap& map_;
  DepthScale scale_;
  std::vector<float> max_mm_;  // by column
  DepthCells cells_;
};

/// Compares row by row: each row is copied, smoothed with its neighbours and divided while it is
/// cached. `row_of_x` returns the buffer of a row's differences (only the face's runs are written).
/// `done` is called when they are complete.
template <class RowOfX, class Done>
void compare(const cv::Mat& grey, const Reference& reference, const FaceRuns& face,
             const DifferenceOptions& options, const LightGain& light, float x_max, cv::Mat& flags,
             RowOfX row_of_x, Done done) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.image.size());
  // Both images are smoothed alike before the division, without pixels outside of the face. The
  // weights of the missing neighbours cancel in the ratio, so that dark pixels are not biased.
  RowSmoother live(options.smoothing, grey.cols), untouched(options.smoothing, grey.cols);
  ReferenceImage::Reader reader(reference.image);
  const auto darkest =
      static_cast<std::int16_t>(std::lround(kGreySteps * too_dark_below(options.noise_sd)));
  std::vector<char> is_measured(
      static_cast<std::size_t>(grey.rows) + static_cast<std::size_t>(live.radius()),
      1);  // by row: all of its pixels
  const auto select = [&](int row) {
    const auto runs = row < grey.rows ? face.of_row(row) : std::span<const FaceRun>();
    std::int16_t* live_row = live.begin_row(row, runs);
    std::int16_t* untouched_row = untouched.begin_row(row, runs);
    if (runs.empty()) return;
    const std::int16_t* reference_row = reader.row(row, runs);
    for (const FaceRun& run : runs) {
      std::int16_t* live_run = live_row + run.first;
      std::int16_t* untouched_run = untouched_row + run.first;
      std::uint8_t* flags_run = flags.ptr<std::uint8_t>(row) + run.first;
      if (copy_row(grey.ptr<std::uint8_t>(row) + run.first, reference_row + run.first, darkest,
                   run.size(), live_run, untouched_run)) {
        std::fill_n(flags_run, run.size(), std::uint8_t{kMeasured});
      } else {
        flag_unmeasurable_row(darkest, run.size(), live_run, untouched_run, flags_run);
        is_measured[static_cast<std::size_t>(row)] = 0;
      }
    }
  };
  for (int row = 0; row < live.radius(); ++row) select(row);
  for (int row = 0; row < grey.rows; ++row) {
    select(row + live.radius());
    const auto runs = face.of_row(row);
    float* x = row_of_x(row);
    auto* row_flags = flags.ptr<std::uint8_t>(row);
    const std::array<float, 3> light_here = light.of_row(row);
    for (const FaceRun& run : runs) {
      const SmoothRow smooth{live.smoothed(row, run), untouched.smoothed(row, run),
                             untouched.raw(row, run)};
      float* x_run = x + run.first;
      if (is_measured[static_cast<std::size_t>(row)] == 0 ||
          !divide_plain_row(smooth, light_here, run.first, x_max, run.size(), x_run))
        divide_row(smooth, row_flags + run.first, light_here, run.first, x_max, run.size(), x_run);
    }
    clear_outside(runs, grey.cols, row_flags, fill_off_face);
    done(row);
  }
}

/// One frame's noise, grey levels, from which standard deviations are computed.
double frame_noise(const cv::Mat& grey, const Reference& reference, const FaceRuns& face,
                   const DifferenceOptions& options) {
  if (!options.measure_noise) return options.noise_sd;
  return noise_against_reference(grey, reference.image, reference.noise_gain, face)
      .value_or(options.noise_sd);
}

LightGain frame_light(const cv::Mat& grey, const Reference& reference, const FaceRuns& face,
                      const DifferenceOptions& options, double noise_sd) {
  if (!options.correct_light) return {};
  return light_gain(grey, reference.image, face, options.noise_sd, reference.noise_gain, noise_sd);
}

/// All of a difference but its noise.
Difference difference_with(const cv::Mat& grey, const Reference& reference, const FaceRuns& face,
                           const DifferenceOptions& options, const LightGain& light) {
  Difference result;
  result.x = pooled_image(grey.size(), CV_32FC1);
  result.flags = pooled_image(grey.size(), CV_8UC1);
  result.face = face;
  result.blur_px2 = options.smoothing.blur_px2();
  result.light = light;
  compare(
      grey, reference, result.face, options, result.light, std::numeric_limits<float>::infinity(),
      result.flags, [&](int row) { return result.x.ptr<float>(row); },
      [&](int row) {
        clear_outside(result.face.of_row(row), grey.cols, result.x.ptr<float>(row), fill_nan);
      });
  return result;
}

DepthMap depth_map_in_one_pass(const cv::Mat& grey, const Reference& reference,
                               const FaceShape& shape, const FaceRuns& face,
                               const DifferenceOptions& options, const Mapping& mapping,
                               const LightGain& light) {
  DepthMap map{pooled_image(grey.size(), CV_32FC1),
               pooled_image(grey.size(), CV_8UC1),
               {},
               0.0,
               0.0,
               light,
               false};
  DepthMapper depth_mapper(mapping, shape, face, map);
  std::vector<float> x(static_cast<std::size_t>(grey.cols));
  compare(
      grey, reference, face, options, map.light, static_cast<float>(mapping.x_max()), map.flags,
      [&](int) { return x.data(); }, [&](int row) { depth_mapper(row, x.data()); });
  depth_mapper.finish();
  return map;
}

}  // namespace

Difference difference(const cv::Mat& grey, const Reference& reference, const FaceShape& shape,
                      const DifferenceOptions& options) {
  CV_Assert(shape.width_px() == grey.cols);
  const FaceRuns face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  const double noise_sd = frame_noise(grey, reference, face, options);
  Difference result = difference_with(grey, reference, face, options,
                                      frame_light(grey, reference, face, options, noise_sd));
  result.grey_sd = options.smoothing.noise_factor() * noise_sd * result.light.noise_ratio() *
                   std::hypot(1.0, reference.noise_gain);
  return result;
}

DepthMap depth_map(const Difference& compared, const Mapping& mapping, const FaceShape& shape) {
  Difference difference = compared;
  remove_light_spread(mapping.parameters(), shape, &difference);
  DepthMap map{pooled_image(difference.x.size(), CV_32FC1),
               difference.flags.clone(),
               {},
               0.0,
               0.0,
               difference.light,
               false,
               difference.spread_removed};
  DepthMapper depth_mapper(mapping, shape, difference.face, map);
  const auto x_max = static_cast<float>(mapping.x_max());
  for (int row = 0; row < difference.x.rows; ++row) {
    const float* x = difference.x.ptr<float>(row);
    for (const FaceRun& run : difference.face.of_row(row))
      flag_row(x + run.first, x_max, run.size(), map.flags.ptr<std::uint8_t>(row) + run.first);
    depth_mapper(row, x);
  }
  depth_mapper.finish();
  return map;
}

DepthMap depth_map(const cv::Mat& grey, const Reference& reference, const FaceShape& shape,
                   const DifferenceOptions& options, const Mapping& mapping) {
  CV_Assert(shape.width_px() == grey.cols);
  const FaceRuns face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  const double noise_sd = frame_noise(grey, reference, face, options);
  const LightGain light = frame_light(grey, reference, face, options, noise_sd);
  DepthMap map =
      mapping.parameters().spread.is_local()
          ? depth_map_in_one_pass(grey, reference, shape, face, options, mapping, light)
          : depth_map(difference_with(grey, reference, face, options, light), mapping, shape);
  map.is_light_unknown = options.correct_light && light.inlier_fraction() == 0;
  map.live_sd = options.smoothing.noise_factor() * noise_sd * light.noise_ratio();
  map.noise_mm = mapping.slope_mm(0.0) * map.live_sd * std::hypot(1.0, reference.noise_gain) /
                 mean_brightness(grey, face);
  if (std::vector<float> gain = map.spread_removed.noise_gain; !gain.empty())
    map.noise_mm *= static_cast<double>(upper_median(gain));
  return map;
}

namespace {

constexpr int kMaxAtOnce = 255 * kBlock;  // more would overflow the counts of single bytes

ALLTACT_WIDE int count_of(const std::uint8_t* flags, int count, std::uint8_t flag) {
  std::array<std::uint8_t, kBlock> found{};  // by lane of a block
  int u = 0;
  for (; u + kBlock <= count; u += kBlock)
    for (std::size_t k = 0; k < kBlock; ++k)
      found[k] =
          static_cast<std::uint8_t>(found[k] + (flags[static_cast<std::size_t>(u) + k] == flag));
  int all = std::accumulate(found.begin(), found.end(), 0);
  for (; u < count; ++u) all += flags[u] == flag ? 1 : 0;
  return all;
}

}  // namespace

FlagFractions flag_fractions(const cv::Mat& flags, int every_row) {
  CV_Assert(flags.type() == CV_8UC1);
  std::array<double, kPixelFlagCount> counts{};
  for (int v = every_row / 2; v < flags.rows; v += every_row)
    for (int u = 0; u < flags.cols; u += kMaxAtOnce)
      for (std::size_t k = 0; k < counts.size(); ++k)
        counts[k] += count_of(flags.ptr<std::uint8_t>(v) + u, std::min(kMaxAtOnce, flags.cols - u),
                              static_cast<std::uint8_t>(k));
  counts[kOffFace] = 0;
  double face = 0;
  for (const double count : counts) face += count;
  FlagFractions shares{};
  if (face > 0)
    for (std::size_t k = 0; k < counts.size(); ++k) shares.of[k] = counts[k] / face;
  return shares;
}

void flag_hidden(const std::vector<HiddenColumn>& columns, cv::Mat* flags) {
  CV_Assert(flags->type() == CV_8UC1);
  for (const HiddenColumn& column : columns) {
    const int first = std::max(0, static_cast<int>(std::ceil(column.upper_v)));
    const int last = std::min(flags->rows - 1, static_cast<int>(std::floor(column.lower_v)));
    for (int v = first; v <= last; ++v) {
      std::uint8_t& flag = flags->at<std::uint8_t>(v, column.u);
      if (flag == kOffFace) flag = kHiddenEnd;
    }
  }
}

namespace {

ALLTACT_WIDE void add(const float* __restrict depth, int count, float* __restrict sum) {
  for (int u = 0; u < count; ++u)
    sum[u] += depth[u] == depth[u] ? depth[u] : 0.0F;  // NaN is not itself
}

ALLTACT_WIDE void average_columns(const float* __restrict sum, int cells, float* __restrict mean) {
  static_assert(kDepthCellPx == 4);
  for (int x = 0; x < cells; ++x) {
    const float* four = sum + std::ptrdiff_t{4} * x;
    mean[x] = (four[0] + four[1] + four[2] + four[3]) / 16;
  }
}

}  // namespace

DepthCells::DepthCells(const cv::Size& image_size)
    : image_size_(image_size),
      mean_mm_((image_size.height + kDepthCellPx - 1) / kDepthCellPx,
               (image_size.width + kDepthCellPx - 1) / kDepthCellPx, CV_32FC1),
      sum_(static_cast<std::size_t>(std::ptrdiff_t{mean_mm_.cols} * kDepthCellPx), 0.0F) {}

void DepthCells::add_row(int row, std::span<const FaceRun> runs, const float* depth_mm) {
  for (const FaceRun& run : runs) add(depth_mm + run.first, run.size(), sum_.data() + run.first);
  if ((row + 1) % kDepthCellPx != 0 && row + 1 != image_size_.height) return;
  average_columns(sum_.data(), mean_mm_.cols, mean_mm_.ptr<float>(row / kDepthCellPx));
  std::fill(sum_.begin(), sum_.end(), 0.0F);
}

cv::Mat depth_cells(const cv::Mat& depth_mm) {
  DepthCells cells(depth_mm.size());
  for (int row = 0; row < depth_mm.rows; ++row) {
    const FaceRun full_row{row, 0, depth_mm.cols, 0};
    cells.add_row(row, {&full_row, 1}, depth_mm.ptr<float>(row));
  }
  return cells.mean_mm();
}

std::optional<double> noise_against_reference(const cv::Mat& grey, const ReferenceImage& reference,
                                              double noise_gain, const FaceRuns& face) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.size());
  constexpr int kRows = 48;                   // are enough
  std::array<std::int64_t, 129> histogram{};  // noise of up to 12 grey levels in both images
  ReferenceImage::Reader reader(reference);
  const int first_row = face.runs.empty() ? 0 : face.runs.front().row,
            end_row = face.runs.empty() ? 0 : face.runs.back().row + 1;
  const int step = std::max(1, (end_row - first_row) / kRows);
  for (int v = first_row + step / 2; v < end_row; v += step) {
    const auto runs = face.of_row(v);
    if (runs.empty()) continue;
    const std::int16_t* untouched = reader.row(v, runs);
    const auto* live = grey.ptr<std::uint8_t>(v);
    const auto is_usable = [&](int u) {
      return live[u] >= kTooDarkBelow && live[u] < kClippedFrom &&
             untouched[u] >= kTooDarkBelow * kGreySteps && untouched[u] < kClippedFrom * kGreySteps;
    };
    const auto off = [&](int u) { return live[u] * kGreySteps - untouched[u]; };
    for (const FaceRun& run : runs) {
      int usable = 0;  // usable pixels in a row
      for (int u = run.first; u < run.end; ++u) {
        usable = is_usable(u) ? usable + 1 : 0;
        if (usable < 3) continue;
        const int steps = std::abs(off(u - 2) - 2 * off(u - 1) + off(u));
        const auto levels = static_cast<std::size_t>((steps + kGreySteps / 2) / kGreySteps);
        if (levels < histogram.size()) ++histogram[levels];
      }
    }
  }
  const auto sd = sd_of_differences(histogram);
  if (!sd) return std::nullopt;
  return std::max(*sd / std::sqrt(6.0 * (1.0 + noise_gain * noise_gain)), std::sqrt(1.0 / 12.0));
}

namespace {

ALLTACT_WIDE void scale_row(const float* __restrict factor, int count, float* __restrict depth) {
  for (int i = 0; i < count; ++i) depth[i] *= factor[i];
}

/// factor + across t, t = (v - middle) per_px within -1 to 1.
ALLTACT_WIDE void scale_row_across(const float* __restrict factor, const float* __restrict across,
                                   const float* __restrict middle_v, const float* __restrict per_px,
                                   float v, int count, float* __restrict depth) {
  for (int i = 0; i < count; ++i) {
    const float t = (v - middle_v[i]) * per_px[i];
    const float above = t > -1.0F ? t : -1.0F;
    depth[i] *= factor[i] + across[i] * (above < 1.0F ? above : 1.0F);
  }
}

}  // namespace

DepthScale::DepthScale(const MappingParameters& mapping, const FaceShape& shape) {
  const FaceVariation& variation = mapping.variation;
  const bool is_projected = mapping.along == MappingAlong::kProjected;
  if (variation.is_none() && !is_projected) return;
  by_column_ = is_projected ? shape.along_z_per_normal()
                            : std::vector<float>(static_cast<std::size_t>(shape.width_px()), 1.0F);
  if (variation.is_none()) return;
  across_ = middle_v_ = across_per_px_ = std::vector<float>(by_column_.size(), 0.0F);
  for (int u = 0; u < shape.width_px(); ++u) {
    const auto i = static_cast<std::size_t>(u);
    const FaceColumn& column = shape.columns()[i];
    if (!column.valid) continue;
    const double along_z = static_cast<double>(by_column_[i]);
    const double middle_v = 0.5 * (column.upper_v + column.lower_v);
    // Splits f into a factor that is constant across the face and a slope across it.
    const double s = variation.within(shape.position_mm(u, middle_v)).x();
    by_column_[i] = static_cast<float>(along_z * (1.0 + variation.part.x() * s));
    across_[i] = static_cast<float>(along_z * variation.part.y());
    const double per_px = shape.position_mm(u, middle_v + 1.0).y() / variation.half_mm.y();
    across_per_px_[i] = static_cast<float>(per_px);
    middle_v_[i] =
        static_cast<float>(middle_v + variation.middle_mm.y() / (per_px * variation.half_mm.y()));
  }
}

void DepthScale::scale(int v, int first, int count, float* depth_mm) const {
  if (across_.empty())
    scale_row(by_column_.data() + first, count, depth_mm);
  else
    scale_row_across(by_column_.data() + first, across_.data() + first, middle_v_.data() + first,
                     across_per_px_.data() + first, static_cast<float>(v), count, depth_mm);
}

namespace {

// A cell below this mean depth only needs scaling; it lies above the noise.
constexpr float kIndentedMm = 0.02F, kMaxIndentedMm = 0.1F;
// The same limit for bulges: shallower ones are so wide that scaling is off by a few hundredths.
constexpr double kBulgingMm = 0.05;
// 3 sd, from the first quartile of a normal law's magnitudes (0.319 sd)
constexpr float kAboveNoise = 9.4F;
constexpr int kSteps = 6;  // each at least halves the error

/// The finger's length profile in the x-z plane, along the middle of the face. Across it a twisted
/// face continues along its normal.
class Profile {
 public:
  std::vector<double> foot_x_mm;  ///< x of the contact-free face seen along the normal, ascending
  std::vector<double> z_mm, normal_x, normal_y, normal_z;

  explicit Profile(const FaceShape& shape) {
    const double layer_mm = shape.face().layer_mm;
    for (int u = 0; u < shape.width_px(); ++u) {
      const FaceColumn& column = shape.columns()[static_cast<std::size_t>(u)];
      const auto local = shape.at(u, 0.5 * (column.upper_v + column.lower_v));
      if (!local) continue;
      const double foot = local->view_point_mm.x() + layer_mm * local->normal.x();
      if (!foot_x_mm.empty() && foot <= foot_x_mm.back()) continue;
      foot_x_mm.push_back(foot);
      z_mm.push_back(local->view_point_mm.z());
      normal_x.push_back(local->normal.x());
      normal_y.push_back(local->normal.y());
      normal_z.push_back(local->normal.z());
    }
  }

  struct Section {
    double z_mm, normal_x, normal_y, normal_z;
  };
  /// Section whose normal leads to x on the contact-free face; clamped to the ends. The search
  /// starts at the last result, because neighbours are requested in order.
  [[nodiscard]] Section at(double x_mm) {
    const std::size_t last = foot_x_mm.size() - 1;
    std::size_t r = last_index_;
    while (r < last && foot_x_mm[r] < x_mm) ++r;
    while (r > 1 && !(foot_x_mm[r - 1] < x_mm)) --r;
    last_index_ = r;
    const std::size_t l = r - 1;
    const double part = std::clamp((x_mm - foot_x_mm[l]) / (foot_x_mm[r] - foot_x_mm[l]), 0.0, 1.0);
    const auto between = [&](const std::vector<double>& values) {
      return values[l] + part * (values[r] - values[l]);
    };
    return {between(z_mm), between(normal_x), between(normal_y), between(normal_z)};
  }

 private:
  std::size_t last_index_ = 1;
};

/// Threshold of a cell's mean depth for indentations and bulges. Derived from the first quartile of
/// the magnitudes.
float indented_mm(const cv::Mat& cells_mm) {
  std::vector<float> means;
  for (auto mean = cells_mm.begin<float>(); mean != cells_mm.end<float>(); ++mean)
    if (std::isfinite(*mean)) means.push_back(std::abs(*mean));
  if (means.empty()) return kIndentedMm;
  const auto quarter = means.begin() + static_cast<std::ptrdiff_t>(means.size() / 4);
  std::nth_element(means.begin(), quarter, means.end());
  return std::clamp(kAboveNoise * *quarter, kIndentedMm, kMaxIndentedMm);
}

/// Cells near an indentation, where another pixel can see the line along z.
cv::Mat indented_cells(const cv::Mat& cells_mm, const FaceShape& shape) {
  const double min_mm = static_cast<double>(indented_mm(cells_mm));
  cv::Mat indented = (cells_mm > min_mm) | (cells_mm < -std::max(min_mm, kBulgingMm));
  double nearest_mm = 1e9;
  for (const FaceColumn& column : shape.columns())
    if (column.valid) nearest_mm = std::min(nearest_mm, column.z_mm);
  const double px_per_mm = 1.0 / shape.camera().mm_per_px_at(nearest_mm);
  const int reach =
      1 + static_cast<int>(std::ceil(shape.face().layer_mm * px_per_mm / kDepthCellPx));
  cv::dilate(indented, indented, cv::Mat::ones(3, 2 * reach + 1, CV_8U));
  return indented;
}

struct Lookup {
  double depth_mm = NAN;
  cv::Point seen_at;  ///< the pixel that sees the line
};

/// Depth along z over one pixel; NaN where the pixel that sees the line has no measurement.
Lookup measure_along_z(const cv::Mat& depth_normal_mm, const FaceShape& shape, Profile& profile,
                       const FaceShape::Local& here) {
  const double layer_mm = shape.face().layer_mm;
  const Eigen::Vector3d untouched = untouched_point_mm(here, layer_mm, MappingAlong::kZ);
  // Distance of the contact-free face beyond the profile on this line.
  const Profile::Section foot = profile.at(untouched.x());
  const double beyond_mm = untouched.z() - foot.z_mm - foot.normal_z * layer_mm;
  double depth = 0, pressed_z = 0;
  cv::Point at;
  for (int step = 0; step < kSteps; ++step) {
    // The foot moves back along the normal as the layer thins.
    Profile::Section section = profile.at(untouched.x());
    section = profile.at(untouched.x() + section.normal_x * depth);
    const double thickness = layer_mm - depth;
    const double falls_mm = section.normal_y * section.normal_y / section.normal_z * depth;
    const double z_mm = section.z_mm + beyond_mm - falls_mm;
    const Eigen::Vector3d seen_at(untouched.x() - section.normal_x * thickness,
                                  untouched.y() - section.normal_y * thickness, z_mm);
    const auto pixel = shape.camera().project(seen_at);
    if (!pixel) return {};
    const double found = bilinear(depth_normal_mm, *pixel);
    if (!std::isfinite(found)) return {};
    at = {static_cast<int>(std::lround(pixel->x())), static_cast<int>(std::lround(pixel->y()))};
    depth = step < 2 ? found : 0.5 * (depth + found);
    pressed_z = z_mm + section.normal_z * (layer_mm - depth);
  }
  return {untouched.z() - pressed_z, at};
}

}  // namespace

cv::Mat depth_along_z(const cv::Mat& depth_normal_mm, const cv::Mat& cells_mm,
                      const FaceShape& shape, cv::Mat& flags) {
  CV_Assert(depth_normal_mm.type() == CV_32FC1 && depth_normal_mm.cols == shape.width_px() &&
            flags.type() == CV_8UC1 && flags.size() == depth_normal_mm.size());
  cv::Mat depth_mm = depth_normal_mm.clone();
  const cv::Mat flags_before = flags.clone();
  Profile profile(shape);
  const std::vector<float>& along_z = shape.along_z_per_normal();
  const cv::Mat indented = indented_cells(cells_mm, shape);
  for (int row = 0; row < depth_mm.rows; ++row) {
    const std::uint8_t* cell = indented.ptr<std::uint8_t>(row / kDepthCellPx);
    float* depth = depth_mm.ptr<float>(row);
    auto* flag = flags.ptr<std::uint8_t>(row);
    for (int u = 0; u < depth_mm.cols; ++u) {
      // On an even face, depth along the normal and along z differ by a factor only.
      depth[u] *= along_z[static_cast<std::size_t>(u)];
      if (cell[u / kDepthCellPx] == 0 || !std::isfinite(depth[u]) || profile.foot_x_mm.size() < 2)
        continue;
      const auto here = shape.at(u, row);
      if (!here) continue;
      const Lookup found = measure_along_z(depth_normal_mm, shape, profile, *here);
      if (!std::isfinite(found.depth_mm)) continue;
      depth[u] = static_cast<float>(found.depth_mm);
      flag[u] = flags_before.at<std::uint8_t>(found.seen_at);
    }
  }
  return depth_mm;
}

}  // namespace alltact
