#include "core/sensing/depth/local_depth.h"

#include "core/grey_range.h"
#include "core/numerics/blocks.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/depth/depth_along_z.h"
#include "core/sensing/depth/depth_cells.h"
#include "core/sensing/depth/depth_scale.h"
#include "core/sensing/depth/reference_noise.h"
#include "core/sensing/depth/row_smoother.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/picture_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>

namespace alltact {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr std::int16_t kCeiling = kClippedFrom * kGreySteps;

/// Both brightnesses of a row in steps; true when every pixel of it can be measured, as nearly all
/// rows can.
ALLTACT_WIDE bool copy_row(const std::uint8_t* __restrict grey,
                           const std::int16_t* __restrict reference,
                           std::int16_t darkest,
                           int count,
                           std::int16_t* __restrict live_out,
                           std::int16_t* __restrict reference_out) {
  std::int16_t brightest_seen = 0, darkest_seen = kCeiling;
  in_blocks(
      count, [&](int first, auto size) __attribute__((always_inline)) {
        std::int16_t brightest = 0, darkest_here = kCeiling;
        for (int i = 0; i < size; ++i) {
          const int u = first + i;
          const auto live = static_cast<std::int16_t>(grey[u] * kGreySteps);
          const std::int16_t ref = reference[u];
          live_out[u] = live;
          reference_out[u] = ref;
          const std::int16_t brighter = live > ref ? live : ref;
          brightest = brighter > brightest ? brighter : brightest;
          darkest_here = ref < darkest_here ? ref : darkest_here;
        }
        brightest_seen = std::max(brightest_seen, brightest);
        darkest_seen = std::min(darkest_seen, darkest_here);
      });
  return brightest_seen < kCeiling && darkest_seen >= darkest;
}

/// Says of each pixel of a row whether it can be measured, and sets both to 0 where not.
ALLTACT_WIDE void mark_row(std::int16_t darkest,
                           int count,
                           std::int16_t* __restrict live,
                           std::int16_t* __restrict reference,
                           std::uint8_t* __restrict flags) {
  constexpr std::int16_t measured = kMeasured, unknown = kNoReference, dark = kTooDark,
                         clipped = kSaturated;
  for (int u = 0; u < count; ++u) {
    const std::int16_t ref = reference[u];
    // The last reason wins; each pixel takes the same steps, so that the loop runs in vectors.
    std::int16_t flag = live[u] >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = ref == kNoGrey ? unknown : flag;
    flags[u] = static_cast<std::uint8_t>(flag);
    live[u] = flag == measured ? live[u] : std::int16_t{0};
    reference[u] = flag == measured ? ref : std::int16_t{0};
  }
}

/// `light`: what live pixels are to be multiplied with, in powers of u - first_column. `raw`: the
/// reference before it was smoothed. Amid pixels that could not be measured hardly any
/// of the kernel is left, and its outer weights are negative: such a pixel takes the reason of
/// those around it, by whether it is nearer to black or to clipped. What is measured and
/// beyond x_max is flagged as such.
ALLTACT_WIDE void divide_row(const std::int16_t* __restrict live,
                             const std::int16_t* __restrict reference,
                             const std::int16_t* __restrict raw,
                             std::uint8_t* __restrict flags,
                             const std::array<float, 3>& light,
                             int first_column,
                             float x_max,
                             int count,
                             float* __restrict x) {
  constexpr float measured = kMeasured, clipped = kSaturated, dark = kTooDark,
                  extrapolated = kExtrapolated;
  constexpr float kLeastPart = 0.2F;  // of the kernel: in a corner of the face 0.3 is left
  constexpr float kMiddle = 0.5F * kCeiling;
  const float constant = light[0], slope = light[1], bow = light[2];
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        for (int u = first; u < first + size; ++u) {
          const auto before = static_cast<float>(static_cast<std::int32_t>(flags[u]));
          const float flag = before == extrapolated ? measured : before;  // of a place done twice
          const auto column = static_cast<float>(first_column + u);
          const float correction = constant + column * (slope + column * bow);
          const auto here = static_cast<float>(raw[u]), smooth = static_cast<float>(reference[u]);
          const float thin = here > kMiddle ? clipped : dark;
          const float reason = flag == measured && !(smooth > kLeastPart * here) ? thin : flag;
          const float below = reason == measured ? smooth : 1.0F;
          const float value = (below - correction * static_cast<float>(live[u])) / below;
          const float told = reason == measured ? value : kNaN;
          x[u] = told;
          const float final = told > x_max ? extrapolated : reason;
          flags[u] = static_cast<std::uint8_t>(static_cast<std::int32_t>(final));
        }
      });
}

ALLTACT_WIDE void flag_row(const float* __restrict x,
                           float x_max,
                           int count,
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

/// A layer cannot be pressed in further than it is thick.
ALLTACT_WIDE void bound_row(const float* __restrict most_mm,
                            int count,
                            float* __restrict depth_mm,
                            std::uint8_t* __restrict flags) {
  constexpr float beyond = kBeyondLayer;
  in_blocks(
      count, [=](int first, auto size) __attribute__((always_inline)) {
        int deeper = 0;
        for (int u = first; u < first + size; ++u) deeper |= depth_mm[u] > most_mm[u] ? 1 : 0;
        if (deeper == 0) return;  // as nearly everywhere
        for (int u = first; u < first + size; ++u) {
          const auto flag = static_cast<float>(static_cast<std::int32_t>(flags[u]));
          const float depth = depth_mm[u], most = most_mm[u];
          flags[u] =
              static_cast<std::uint8_t>(static_cast<std::int32_t>(depth > most ? beyond : flag));
          depth_mm[u] = depth > most ? most : depth;
        }
      });
}

/// How far the layer can be pressed in at most, by column, in the direction of the mapping's depth.
std::vector<float> layer_by_column(const MappingParameters& mapping, const FaceShape& shape) {
  constexpr float kMostPerNormal = 3.8637033F;  // 1 / cos of 75 degrees
  const auto layer_mm = static_cast<float>(shape.face().layer_mm);
  const auto width = static_cast<std::size_t>(shape.width_px());
  if (mapping.along == MappingAlong::kNormal) return std::vector<float>(width, layer_mm);
  std::vector<float> most_mm = shape.along_z_per_normal();
  for (float& most : most_mm) most = layer_mm * std::min(most, kMostPerNormal);
  return most_mm;
}

/// What of a row lies outside the face's runs has no measurement.
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

/// Makes a depth map row by row from rows of differences.
class Mapper {
 public:
  Mapper(const Mapping& mapping, const FaceShape& shape, const FaceRuns& face, DepthMap& map)
      : mapping_(mapping),
        shape_(shape),
        face_(face),
        map_(map),
        scale_(mapping.parameters(), shape),
        most_mm_(layer_by_column(mapping.parameters(), shape)),
        cells_(map.depth_mm.size()) {}

  /// Rows in turn; what is too deep is flagged.
  void operator()(int row, const float* x) {
    float* depth = map_.depth_mm.ptr<float>(row);
    auto* flags = map_.flags.ptr<std::uint8_t>(row);
    const auto runs = face_.of_row(row);
    for (const FaceRun& run : runs) {
      mapping_.depths_mm(x + run.first, depth + run.first, run.size());
      if (!scale_.is_one()) scale_.scale(row, run.first, run.size(), depth + run.first);
      bound_row(most_mm_.data() + run.first, run.size(), depth + run.first, flags + run.first);
    }
    clear_outside(runs, map_.depth_mm.cols, depth, fill_nan);
    cells_.add_row(row, runs, depth);
  }

  void finish() {
    map_.cells_mm = cells_.mean_mm();
    if (mapping_.parameters().along != MappingAlong::kNormal) return;
    map_.depth_mm = depth_along_z(map_.depth_mm, map_.cells_mm, shape_);
    map_.cells_mm = depth_cells(map_.depth_mm);
  }

 private:
  const Mapping& mapping_;
  const FaceShape& shape_;
  const FaceRuns& face_;
  DepthMap& map_;
  DepthScale scale_;
  std::vector<float> most_mm_;  // by column
  DepthCells cells_;
};

/// Compares row by row: each row is copied, smoothed with those around it and divided while it is
/// still near the processor. `row_of_x` says where a row's differences go (only the face's runs are
/// written) and `done` is told when they are there.
template <class RowOfX, class Done>
void compare(const cv::Mat& grey,
             const Reference& reference,
             const FaceRuns& face,
             const DifferenceOptions& options,
             const LightGain& light,
             float x_max,
             cv::Mat& flags,
             RowOfX row_of_x,
             Done done) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.picture.size());
  // Both pictures are smoothed alike before the division, with nothing from outside the face: the
  // weights of the missing neighbours cancel in the ratio, and dark pixels are not biased by it.
  RowSmoother live(options.smoothing, grey.cols), untouched(options.smoothing, grey.cols);
  ReferencePicture::Reader reader(reference.picture);
  const auto darkest =
      static_cast<std::int16_t>(std::lround(kGreySteps * too_dark_below(options.noise_sd)));
  const auto select = [&](int row) {
    const auto runs = row < grey.rows ? face.of_row(row) : std::span<const FaceRun>();
    std::int16_t* live_row = live.fresh_row(row, runs);
    std::int16_t* untouched_row = untouched.fresh_row(row, runs);
    if (runs.empty()) return;
    const std::int16_t* reference_row = reader.row(row, runs);
    for (const FaceRun& run : runs) {
      std::int16_t* live_run = live_row + run.first;
      std::int16_t* untouched_run = untouched_row + run.first;
      std::uint8_t* flags_run = flags.ptr<std::uint8_t>(row) + run.first;
      if (copy_row(grey.ptr<std::uint8_t>(row) + run.first,
                   reference_row + run.first,
                   darkest,
                   run.size(),
                   live_run,
                   untouched_run))
        std::fill_n(flags_run, run.size(), std::uint8_t{kMeasured});
      else
        mark_row(darkest, run.size(), live_run, untouched_run, flags_run);
    }
  };
  for (int row = 0; row < live.radius(); ++row) select(row);
  for (int row = 0; row < grey.rows; ++row) {
    select(row + live.radius());
    const auto runs = face.of_row(row);
    float* x = row_of_x(row);
    auto* row_flags = flags.ptr<std::uint8_t>(row);
    const std::array<float, 3> light_here = light.of_row(row);
    for (const FaceRun& run : runs)
      divide_row(live.smoothed(row, run),
                 untouched.smoothed(row, run),
                 untouched.raw(row, run),
                 row_flags + run.first,
                 light_here,
                 run.first,
                 x_max,
                 run.size(),
                 x + run.first);
    clear_outside(runs, grey.cols, row_flags, fill_off_face);
    done(row);
  }
}

/// One frame's noise, grey levels, that standard deviations are told from.
double noise_now(const cv::Mat& grey,
                 const Reference& reference,
                 const FaceRuns& face,
                 const DifferenceOptions& options) {
  if (!options.measure_noise) return options.noise_sd;
  return noise_against_reference(grey, reference.picture, reference.noise_gain, face)
      .value_or(options.noise_sd);
}

LightGain light_now(const cv::Mat& grey,
                    const Reference& reference,
                    const FaceRuns& face,
                    const DifferenceOptions& options,
                    double noise_sd) {
  if (!options.correct_light) return {};
  return light_gain(
      grey, reference.picture, face, options.noise_sd, reference.noise_gain, noise_sd);
}

}  // namespace

Difference difference(const cv::Mat& grey,
                      const Reference& reference,
                      const FaceShape& shape,
                      const DifferenceOptions& options) {
  CV_Assert(shape.width_px() == grey.cols);
  Difference result;
  result.x = pooled_picture(grey.size(), CV_32FC1);
  result.flags = pooled_picture(grey.size(), CV_8UC1);
  result.face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  result.blur_px2 = options.smoothing.blur_px2();
  const double noise_sd = noise_now(grey, reference, result.face, options);
  result.light = light_now(grey, reference, result.face, options, noise_sd);
  result.grey_sd = options.smoothing.noise_part() * noise_sd * result.light.noise_ratio() *
                   std::hypot(1.0, reference.noise_gain);
  compare(
      grey,
      reference,
      result.face,
      options,
      result.light,
      std::numeric_limits<float>::infinity(),
      result.flags,
      [&](int row) { return result.x.ptr<float>(row); },
      [&](int row) {
        clear_outside(result.face.of_row(row), grey.cols, result.x.ptr<float>(row), fill_nan);
      });
  return result;
}

DepthMap depth_map(const Difference& difference, const Mapping& mapping, const FaceShape& shape) {
  DepthMap map{pooled_picture(difference.x.size(), CV_32FC1),
               difference.flags.clone(),
               {},
               0.0,
               0.0,
               difference.light};
  Mapper mapper(mapping, shape, difference.face, map);
  const auto x_max = static_cast<float>(mapping.x_max());
  for (int row = 0; row < difference.x.rows; ++row) {
    const float* x = difference.x.ptr<float>(row);
    for (const FaceRun& run : difference.face.of_row(row))
      flag_row(x + run.first, x_max, run.size(), map.flags.ptr<std::uint8_t>(row) + run.first);
    mapper(row, x);
  }
  mapper.finish();
  return map;
}

DepthMap depth_map(const cv::Mat& grey,
                   const Reference& reference,
                   const FaceShape& shape,
                   const DifferenceOptions& options,
                   const Mapping& mapping) {
  CV_Assert(shape.width_px() == grey.cols);
  DepthMap map{pooled_picture(grey.size(), CV_32FC1),
               pooled_picture(grey.size(), CV_8UC1),
               {},
               0.0,
               0.0,
               {}};
  const FaceRuns face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  const double noise_sd = noise_now(grey, reference, face, options);
  map.light = light_now(grey, reference, face, options, noise_sd);
  Mapper mapper(mapping, shape, face, map);
  std::vector<float> x(static_cast<std::size_t>(grey.cols));
  compare(
      grey,
      reference,
      face,
      options,
      map.light,
      static_cast<float>(mapping.x_max()),
      map.flags,
      [&](int) { return x.data(); },
      [&](int row) { mapper(row, x.data()); });
  mapper.finish();
  map.live_sd = options.smoothing.noise_part() * noise_sd * map.light.noise_ratio();
  map.noise_mm = mapping.slope_mm(0.0) * map.live_sd * std::hypot(1.0, reference.noise_gain) /
                 mean_brightness(grey, face);
  return map;
}

}  // namespace alltact
