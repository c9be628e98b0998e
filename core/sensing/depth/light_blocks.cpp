#include "core/sensing/depth/light_blocks.h"

#include "core/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/sensing/reference/grey_steps.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace alltact {
namespace {

constexpr std::size_t kLanes = 8;  // blocks side by side: the widest vector of doubles
/// Sums of weight s^i t^j up to i + j = 4, of pull s^i t^j up to 2, and of the robust weights.
constexpr std::size_t kMoments = 15, kSums = kMoments + kLightTerms + 1;
using Lanes = std::array<double, kSums * kLanes>;

/// Values of a multiple of kLanes blocks. Each lane has its own sums, whatever the vector width.
struct LaneBlocks {
  const double *s, *t, *ratio, *sd;
  const double* counts;  ///< 1 or 0 by lane, for all of them
};

ALLTACT_WIDE void add_blocks(const LaneBlocks& first,
                             std::size_t count,
                             const double* c,
                             double tukey2,
                             double widening2,
                             double* __restrict sums) {
  for (std::size_t g = 0; g < count; g += kLanes)
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
      const std::size_t i = g + lane;
      const double s = first.s[i], t = first.t[i], ratio = first.ratio[i];
      const double change = c[0] + s * (c[1] + s * c[3] + t * c[4]) + t * (c[2] + t * c[5]);
      const double off = 1.0 - ratio * (1.0 + change);
      const double variance = first.sd[i] * first.sd[i] + widening2;
      const double square = off * off / (tukey2 * variance);
      const double inside = square < 1.0 ? 1.0 - square : 0.0;
      const double share = first.counts[lane] * (inside * inside);
      const double weight = share / variance * ratio;
      const double pull = weight * (1.0 - ratio), own = weight * ratio;
      const double ss = s * s, st = s * t, tt = t * t;
      double* sum = sums + lane;
      const auto put = [&](std::size_t k, double value) __attribute__((always_inline)) {
        sum[k * kLanes] += value;
      };
      put(0, own);
      put(1, own * s), put(2, own * t);
      put(3, own * ss), put(4, own * st), put(5, own * tt);
      put(6, own * (ss * s)), put(7, own * (ss * t)), put(8, own * (s * tt)),
          put(9, own * (t * tt));
      put(10, own * (ss * ss)), put(11, own * (ss * st)), put(12, own * (ss * tt));
      put(13, own * (st * tt)), put(14, own * (tt * tt));
      put(15, pull);
      put(16, pull * s), put(17, pull * t);
      put(18, pull * ss), put(19, pull * st), put(20, pull * tt);
      put(21, share);
    }
}

/// Index of the moment that is the product of two basis terms.
std::size_t moment_of(int i, int j) {
  constexpr std::array<std::array<int, 2>, kLightTerms> powers{
      {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}}};
  const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
  const int t = powers[a][1] + powers[b][1], degree = powers[a][0] + powers[b][0] + t;
  return static_cast<std::size_t>(degree * (degree + 1) / 2 + t);
}

/// Brightnesses of a row that can be compared, 0 elsewhere, and a flag for each.
ALLTACT_WIDE void compare_row(const std::uint8_t* __restrict grey,
                              const std::int16_t* __restrict untouched,
                              int count,
                              std::int32_t* __restrict live,
                              std::int32_t* __restrict reference,
                              std::int32_t* __restrict counts) {
  constexpr std::int32_t darkest = kTooDarkBelow * kGreySteps, ceiling = kClippedFrom * kGreySteps;
  for (int i = 0; i < count; ++i) {
    const std::int32_t now = grey[i], ref = untouched[i];
    const bool can = (now < kClippedFrom) & (ref >= darkest) & (ref < ceiling);
    live[i] = can ? now : 0;
    reference[i] = can ? ref : 0;
    counts[i] = can ? 1 : 0;
  }
}

}  // namespace

void LightBlocks::add(const LightBlock& block) {
  s_.push_back(block.s), t_.push_back(block.t);
  ratio_.push_back(block.ratio), noise_.push_back(block.noise), sd_.push_back(block.sd);
}

LightEquations LightBlocks::equations(const LightTerms& terms,
                                      double tukey,
                                      double widening) const {
  alignas(64) Lanes sums{};
  alignas(64) std::array<double, kLanes> ones;
  ones.fill(1.0);
  const std::size_t full_lanes = size() / kLanes * kLanes;
  const auto add = [&](const LaneBlocks& first, std::size_t count) {
    add_blocks(first, count, terms.data(), tukey * tukey, widening * widening, sums.data());
  };
  add({s_.data(), t_.data(), ratio_.data(), sd_.data(), ones.data()}, full_lanes);
  if (full_lanes < size()) {
    // Pads the last vector with blocks of weight 0.
    std::array<std::array<double, kLanes>, 5> rest{};
    rest[3].fill(1.0);
    for (std::size_t i = full_lanes; i < size(); ++i) {
      const std::size_t lane = i - full_lanes;
      rest[0][lane] = s_[i], rest[1][lane] = t_[i];
      rest[2][lane] = ratio_[i], rest[3][lane] = sd_[i], rest[4][lane] = 1.0;
    }
    add({rest[0].data(), rest[1].data(), rest[2].data(), rest[3].data(), rest[4].data()}, kLanes);
  }
  const auto sum = [&](std::size_t k) {
    double all = 0;
    for (std::size_t lane = 0; lane < kLanes; ++lane) all += sums[k * kLanes + lane];
    return all;
  };
  LightEquations equations;
  for (int i = 0; i < kLightTerms; ++i)
    for (int j = 0; j <= i; ++j)
      equations.normal(i, j) = equations.normal(j, i) = sum(moment_of(i, j));
  for (int i = 0; i < kLightTerms; ++i)
    equations.pull[i] = sum(kMoments + static_cast<std::size_t>(i));
  equations.inlier_sum = sum(kSums - 1);
  return equations;
}

LightBlocks light_blocks(const cv::Mat& grey,
                         const ReferenceImage& reference,
                         const FaceRuns& face,
                         const cv::Rect& bounds,
                         double block_count,
                         double noise_sd,
                         double noise_gain,
                         double floor) {
  LightBlocks blocks;
  const int step = std::max(2, static_cast<int>(std::sqrt(face.pixels() / block_count)));
  const double half_u = 0.5 * bounds.width, half_v = 0.5 * bounds.height;
  ReferenceImage::Reader reader(reference);
  const auto width = static_cast<std::size_t>(grey.cols);
  std::vector<std::int32_t> lives(width), references(width), counts(width);
  for (int v = bounds.y + step / 2; v < bounds.br().y; v += step) {
    const auto runs = face.of_row(v);
    if (runs.empty()) continue;
    const std::int16_t* untouched = reader.row(v, runs);
    for (const FaceRun& run : runs) {
      compare_row(grey.ptr<std::uint8_t>(v) + run.first,
                  untouched + run.first,
                  run.size(),
                  lives.data(),
                  references.data(),
                  counts.data());
      for (int first = 0; first + step <= run.size(); first += step) {
        int sum = 0, reference_sum = 0, count = 0;
        for (int k = first; k < first + step; ++k) {
          const auto i = static_cast<std::size_t>(k);
          sum += lives[i], reference_sum += references[i], count += counts[i];
        }
        if (2 * count < step) continue;
        const double level = static_cast<double>(reference_sum) / kGreySteps;
        const double sd = noise_sd * std::sqrt(count * (1.0 + noise_gain * noise_gain)) / level;
        const double s = (run.first + first + 0.5 * (step - 1) - bounds.x) / half_u - 1.0;
        blocks.add({s,
                    (v - bounds.y) / half_v - 1.0,
                    sum / level,
                    sd,
                    std::sqrt(sd * sd + floor * floor)});
      }
    }
  }
  return blocks;
}

}  // namespace alltact
