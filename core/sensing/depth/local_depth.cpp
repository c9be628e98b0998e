#include "core/sensing/depth/local_depth.h"

#include "core/grey_range.h"
#include "core/sensing/depth/depth_along_z.h"
#include "core/sensing/depth/depth_cells.h"
#include "core/sensing/depth/depth_rows.h"
#include "core/sensing/depth/depth_scale.h"
#include "core/sensing/depth/reference_noise.h"
#include "core/sensing/depth/row_smoother.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/reference/grey_steps.h"
#include "core/sensing/reference/image_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>

namespace alltact {
namespace {

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
      depth_rows::clamp(
          max_mm_.data() + run.first, run.size(), depth + run.first, flags + run.first);
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
void compare(const cv::Mat& grey,
             const Reference& reference,
             const FaceRuns& face,
             const DifferenceOptions& options,
             const LightGain& light,
             float x_max,
             cv::Mat& flags,
             RowOfX row_of_x,
             Done done) {
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
      if (depth_rows::copy(grey.ptr<std::uint8_t>(row) + run.first,
                           reference_row + run.first,
                           darkest,
                           run.size(),
                           live_run,
                           untouched_run)) {
        std::fill_n(flags_run, run.size(), std::uint8_t{kMeasured});
      } else {
        depth_rows::mark(darkest, run.size(), live_run, untouched_run, flags_run);
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
      const depth_rows::SmoothRow smooth{
          live.smoothed(row, run), untouched.smoothed(row, run), untouched.raw(row, run)};
      depth_rows::divide(smooth,
                         is_measured[static_cast<std::size_t>(row)] != 0,
                         light_here,
                         run.first,
                         x_max,
                         run.size(),
                         row_flags + run.first,
                         x + run.first);
    }
    clear_outside(runs, grey.cols, row_flags, fill_off_face);
    done(row);
  }
}

/// One frame's noise, grey levels, from which standard deviations are computed.
double frame_noise(const cv::Mat& grey,
                   const Reference& reference,
                   const FaceRuns& face,
                   const DifferenceOptions& options) {
  if (!options.measure_noise) return options.noise_sd;
  return noise_against_reference(grey, reference.image, reference.noise_gain, face)
      .value_or(options.noise_sd);
}

LightGain frame_light(const cv::Mat& grey,
                      const Reference& reference,
                      const FaceRuns& face,
                      const DifferenceOptions& options,
                      double noise_sd) {
  if (!options.correct_light) return {};
  return light_gain(grey, reference.image, face, options.noise_sd, reference.noise_gain, noise_sd);
}

}  // namespace

Difference difference(const cv::Mat& grey,
                      const Reference& reference,
                      const FaceShape& shape,
                      const DifferenceOptions& options) {
  CV_Assert(shape.width_px() == grey.cols);
  Difference result;
  result.x = pooled_image(grey.size(), CV_32FC1);
  result.flags = pooled_image(grey.size(), CV_8UC1);
  result.face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  result.blur_px2 = options.smoothing.blur_px2();
  const double noise_sd = frame_noise(grey, reference, result.face, options);
  result.light = frame_light(grey, reference, result.face, options, noise_sd);
  result.grey_sd = options.smoothing.noise_factor() * noise_sd * result.light.noise_ratio() *
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
  DepthMap map{pooled_image(difference.x.size(), CV_32FC1),
               difference.flags.clone(),
               {},
               0.0,
               0.0,
               difference.light,
               false};
  DepthMapper depth_mapper(mapping, shape, difference.face, map);
  const auto x_max = static_cast<float>(mapping.x_max());
  for (int row = 0; row < difference.x.rows; ++row) {
    const float* x = difference.x.ptr<float>(row);
    for (const FaceRun& run : difference.face.of_row(row))
      depth_rows::flag_beyond(
          x + run.first, x_max, run.size(), map.flags.ptr<std::uint8_t>(row) + run.first);
    depth_mapper(row, x);
  }
  depth_mapper.finish();
  return map;
}

DepthMap depth_map(const cv::Mat& grey,
                   const Reference& reference,
                   const FaceShape& shape,
                   const DifferenceOptions& options,
                   const Mapping& mapping) {
  CV_Assert(shape.width_px() == grey.cols);
  DepthMap map{pooled_image(grey.size(), CV_32FC1),
               pooled_image(grey.size(), CV_8UC1),
               {},
               0.0,
               0.0,
               {},
               false};
  const FaceRuns face = face_runs(shape, options.edge_margin_px, grey.size(), options.columns);
  const double noise_sd = frame_noise(grey, reference, face, options);
  map.light = frame_light(grey, reference, face, options, noise_sd);
  map.is_light_unknown = options.correct_light && map.light.inlier_fraction() == 0;
  DepthMapper depth_mapper(mapping, shape, face, map);
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
      [&](int row) { depth_mapper(row, x.data()); });
  depth_mapper.finish();
  map.live_sd = options.smoothing.noise_factor() * noise_sd * map.light.noise_ratio();
  map.noise_mm = mapping.slope_mm(0.0) * map.live_sd * std::hypot(1.0, reference.noise_gain) /
                 mean_brightness(grey, face);
  return map;
}

}  // namespace alltact
