#include "core/sensing/local_depth.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/depth_along_z.h"
#include "core/sensing/picture_pool.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace alltact {
namespace {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kCeiling = 250.0F;  // grey levels from here on are taken as clipped

/// One row: what can be measured, and both brightnesses with 0 where nothing can.
ALLTACT_WIDE void select_row(const std::uint8_t* __restrict grey,
                             const float* __restrict reference,
                             float darkest,
                             int count,
                             float* __restrict live_out,
                             float* __restrict reference_out,
                             std::uint8_t* __restrict flags) {
  constexpr float measured = kMeasured, off_face = kOffFace, dark = kTooDark, clipped = kSaturated;
  for (int u = 0; u < count; ++u) {
    const auto live = static_cast<float>(static_cast<std::int32_t>(grey[u]));
    const float ref = reference[u];
    // The last reason wins. Flags are small whole numbers in float and each pixel takes the same
    // steps, so that the loop runs in vectors.
    float flag = live >= kCeiling ? clipped : measured;
    flag = ref >= kCeiling ? clipped : flag;
    flag = ref < darkest ? dark : flag;
    flag = ref == ref ? flag : off_face;  // NaN is not itself
    flags[u] = static_cast<std::uint8_t>(static_cast<std::int32_t>(flag));
    live_out[u] = flag == measured ? live : 0.0F;
    reference_out[u] = flag == measured ? ref : 0.0F;
  }
}

/// out = a middle with the pairs of neighbours at the next two distances from it on both sides; and
/// two distances more.
ALLTACT_WIDE void weigh_first(const float* __restrict middle,
                              const float* const* pairs,
                              const float* weights,
                              int count,
                              float* __restrict out) {
  const float *a = pairs[0], *b = pairs[1], *c = pairs[2], *d = pairs[3];
  const float w0 = weights[0], w1 = weights[1], w2 = weights[2];
  for (int i = 0; i < count; ++i) out[i] = w0 * middle[i] + w1 * (a[i] + b[i]) + w2 * (c[i] + d[i]);
}
ALLTACT_WIDE void weigh_more(const float* const* pairs,
                             const float* weights,
                             int count,
                             float* __restrict out) {
  const float *a = pairs[0], *b = pairs[1], *c = pairs[2], *d = pairs[3];
  const float w1 = weights[0], w2 = weights[1];
  for (int i = 0; i < count; ++i) out[i] += w1 * (a[i] + b[i]) + w2 * (c[i] + d[i]);
}

/// A Gaussian's weights of the middle and of an even number of distances from it.
std::vector<float> gaussian_weights(double sd_px) {
  const int radius = sd_px > 0.0 ? static_cast<int>(std::ceil(2.0 * sd_px)) : 0;
  std::vector<double> weights;
  double sum = 0;
  for (int k = 0; k <= radius; ++k) {
    const double z = radius > 0 ? k / sd_px : 0.0;
    weights.push_back(std::exp(-0.5 * z * z));
    sum += (k == 0 ? 1.0 : 2.0) * weights.back();
  }
  std::vector<float> result;
  for (const double weight : weights) result.push_back(static_cast<float>(weight / sum));
  while (result.size() < 3 || result.size() % 2 == 0) result.push_back(0.0F);
  return result;
}

/// Smooths a picture that is given row by row, keeping only the rows that the kernel spans. Beyond
/// what was given there is nothing (0).
class RowSmoother {
 public:
  RowSmoother(const std::vector<float>& weights, int width)
      : weights_(weights),
        radius_(static_cast<int>(weights.size()) - 1),
        width_(width),
        step_(width + 2 * radius_),
        rows_(static_cast<std::size_t>((2 * radius_ + 1) * step_), 0.0F),
        filled_(static_cast<std::size_t>(2 * radius_ + 1)),
        sums_(static_cast<std::size_t>(step_), 0.0F),
        smooth_(static_cast<std::size_t>(width)) {}

  [[nodiscard]] int radius() const { return radius_; }

  /// The row, all 0, to be filled within the face's runs. Every row is to be asked for in turn.
  float* fresh_row(int number, std::span<const FaceRun> runs) {
    std::vector<FaceRun>& old = filled_[slot(number)];
    float* begin = line(number);
    for (const FaceRun& run : old) std::fill(begin + run.first, begin + run.end, 0.0F);
    old.assign(runs.begin(), runs.end());
    return begin;
  }

  /// A run of row `number` smoothed; valid until the next call. All rows up to `radius` below it
  /// must have been given.
  const float* smoothed(int number, const FaceRun& run) {
    const int from = std::max(run.first - radius_, 0), to = std::min(run.end + radius_, width_);
    float* sums = sums_.data() + radius_;
    // Beyond the picture there is nothing.
    std::fill(sums + run.first - radius_, sums + from, 0.0F);
    std::fill(sums + to, sums + run.end + radius_, 0.0F);
    weigh(line(number) + from, to - from, sums + from, [&](int k) {
      return std::pair(line(number - k) + from, line(number + k) + from);
    });
    weigh(sums + run.first, run.size(), smooth_.data() + run.first, [&](int k) {
      return std::pair(sums + run.first - k, sums + run.first + k);
    });
    return smooth_.data() + run.first;
  }

 private:
  template <class Neighbours>
  void weigh(const float* middle, int count, float* out, Neighbours neighbours) const {
    for (int k = 1; k < radius_; k += 2) {
      const auto [a, b] = neighbours(k);
      const auto [c, d] = neighbours(k + 1);
      const std::array<const float*, 4> pairs{a, b, c, d};
      if (k == 1)
        weigh_first(middle, pairs.data(), weights_.data(), count, out);
      else
        weigh_more(pairs.data(), weights_.data() + k, count, out);
    }
  }
  [[nodiscard]] std::size_t slot(int number) const {
    const int count = 2 * radius_ + 1;
    return static_cast<std::size_t>((number % count + count) % count);
  }
  float* line(int number) {
    return rows_.data() + slot(number) * static_cast<std::size_t>(step_) + radius_;
  }

  std::vector<float> weights_;  // of the middle and of each distance from it
  int radius_, width_, step_;
  std::vector<float> rows_;  // a ring, each with radius_ zeros on both sides
  std::vector<std::vector<FaceRun>> filled_;
  std::vector<float> sums_, smooth_;
};

ALLTACT_WIDE void divide_row(const float* __restrict live,
                             const float* __restrict reference,
                             const std::uint8_t* __restrict flags,
                             int count,
                             float* __restrict x) {
  constexpr float measured = kMeasured;
  for (int u = 0; u < count; ++u) {
    const auto flag = static_cast<float>(static_cast<std::int32_t>(flags[u]));
    const float below = flag == measured ? reference[u] : 1.0F;
    const float value = (below - live[u]) / below;
    x[u] = flag == measured ? value : kNaN;
  }
}

ALLTACT_WIDE void flag_row(const float* __restrict x,
                           float x_max,
                           int count,
                           std::uint8_t* __restrict flags) {
  constexpr float beyond = kExtrapolated;
  for (int u = 0; u < count; ++u) {
    const auto flag = static_cast<float>(static_cast<std::int32_t>(flags[u]));
    flags[u] = static_cast<std::uint8_t>(static_cast<std::int32_t>(x[u] > x_max ? beyond : flag));
  }
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

/// One row of depth from one row of differences, whose flags it completes.
void map_row(std::span<const FaceRun> runs,
             const float* x,
             const Mapping& mapping,
             int width,
             float* depth,
             std::uint8_t* flags) {
  const auto x_max = static_cast<float>(mapping.x_max());
  for (const FaceRun& run : runs) {
    mapping.depths_mm(x + run.first, depth + run.first, run.size());
    flag_row(x + run.first, x_max, run.size(), flags + run.first);
  }
  clear_outside(runs, width, depth, fill_nan);
}

void turn_along_z(const Mapping& mapping, const FaceShape& shape, DepthMap& map) {
  if (mapping.parameters().along == MappingAlong::kNormal)
    map.depth_mm = depth_along_z(map.depth_mm, shape);
}

/// Compares row by row: each row is selected, smoothed with those around it and divided while it is
/// still near the processor. `row_of_x` says where a row's differences go (only the face's runs are
/// written) and `done` is told when they are there.
template <class RowOfX, class Done>
void compare(const cv::Mat& grey,
             const Reference& reference,
             const FaceRuns& face,
             const DifferenceOptions& options,
             cv::Mat& flags,
             RowOfX row_of_x,
             Done done) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.picture.size());
  // Both pictures are smoothed alike before the division, with nothing from outside the face: the
  // weights of the missing neighbours cancel in the ratio, and dark pixels are not biased by it.
  const auto weights = gaussian_weights(options.smoothing_px);
  RowSmoother live(weights, grey.cols), untouched(weights, grey.cols);
  ReferencePicture::Reader reader(reference.picture);
  const float darkest = static_cast<float>(std::max(8.0, 6.0 * options.noise_sd));
  const auto select = [&](int row) {
    const auto runs = row < grey.rows ? face.of_row(row) : std::span<const FaceRun>();
    float* live_row = live.fresh_row(row, runs);
    float* untouched_row = untouched.fresh_row(row, runs);
    if (runs.empty()) return;
    const float* reference_row = reader.row(row);
    for (const FaceRun& run : runs)
      select_row(grey.ptr<std::uint8_t>(row) + run.first,
                 reference_row + run.first,
                 darkest,
                 run.size(),
                 live_row + run.first,
                 untouched_row + run.first,
                 flags.ptr<std::uint8_t>(row) + run.first);
  };
  for (int row = 0; row < live.radius(); ++row) select(row);
  for (int row = 0; row < grey.rows; ++row) {
    select(row + live.radius());
    const auto runs = face.of_row(row);
    float* x = row_of_x(row);
    auto* row_flags = flags.ptr<std::uint8_t>(row);
    for (const FaceRun& run : runs)
      divide_row(live.smoothed(row, run),
                 untouched.smoothed(row, run),
                 row_flags + run.first,
                 run.size(),
                 x + run.first);
    clear_outside(runs, grey.cols, row_flags, fill_off_face);
    done(row);
  }
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
  result.face = face_runs(shape, options.edge_margin_px, grey.size());
  // One frame's noise and the reference's own, averaged over the kernel: sd / (2 sqrt(pi) s).
  const double averaging = options.smoothing_px > 0.0
                               ? std::min(1.0, 1.0 / (2.0 * std::sqrt(M_PI) * options.smoothing_px))
                               : 1.0;
  result.grey_sd = averaging * options.noise_sd * std::hypot(1.0, reference.noise_gain);
  compare(
      grey,
      reference,
      result.face,
      options,
      result.flags,
      [&](int row) { return result.x.ptr<float>(row); },
      [&](int row) {
        clear_outside(result.face.of_row(row), grey.cols, result.x.ptr<float>(row), fill_nan);
      });
  return result;
}

DepthMap depth_map(const Difference& difference, const Mapping& mapping, const FaceShape& shape) {
  DepthMap map{pooled_picture(difference.x.size(), CV_32FC1), difference.flags.clone()};
  for (int row = 0; row < difference.x.rows; ++row)
    map_row(difference.face.of_row(row),
            difference.x.ptr<float>(row),
            mapping,
            difference.x.cols,
            map.depth_mm.ptr<float>(row),
            map.flags.ptr<std::uint8_t>(row));
  turn_along_z(mapping, shape, map);
  return map;
}

DepthMap depth_map(const cv::Mat& grey,
                   const Reference& reference,
                   const FaceShape& shape,
                   const DifferenceOptions& options,
                   const Mapping& mapping) {
  CV_Assert(shape.width_px() == grey.cols);
  DepthMap map{pooled_picture(grey.size(), CV_32FC1), pooled_picture(grey.size(), CV_8UC1)};
  const FaceRuns face = face_runs(shape, options.edge_margin_px, grey.size());
  std::vector<float> x(static_cast<std::size_t>(grey.cols));
  compare(
      grey,
      reference,
      face,
      options,
      map.flags,
      [&](int) { return x.data(); },
      [&](int row) {
        map_row(face.of_row(row),
                x.data(),
                mapping,
                grey.cols,
                map.depth_mm.ptr<float>(row),
                map.flags.ptr<std::uint8_t>(row));
      });
  turn_along_z(mapping, shape, map);
  return map;
}

}  // namespace alltact
