#include "core/sensing/depth/light_gain.h"

#include "core/image/grey_range.h"
#include "core/numerics/dispatch.h"
#include "core/numerics/median.h"
#include "core/sensing/reference/image_warp.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kTargetBlocks = 600;  // enough for six terms, few enough to cost little
constexpr double kFloor = 0.002;       // errors of references apart from noise
constexpr double kTukey = 4.0;         // sigmas beyond which a block has no weight
constexpr double kConstantSd = 0.5;    // prior sd of the changes
constexpr double kShapeSd = 0.05;
constexpr double kAlike = 2.0;   // times the shortest interval of ratios
constexpr double kPatches = 30;  // of the face; errors of references are correlated within each
constexpr int kMinBlocks = 20;
constexpr double kBrighter = 0.03;  // more than any halo around a contact
// A second light is searched for where at least this share of the face is brighter than the first
// fit. At least this share of those blocks must be its inliers, and at most this share may stay
// brighter.
constexpr double kMuchBrighter = 0.1, kAgreeing = 0.6, kLeftBrighter = 0.02;

using Terms = LightTerms;

cv::Rect bounds_of(const FaceRuns& face) {
  if (face.runs.empty()) return {};
  int left = face.runs.front().first, right = face.runs.front().end;
  for (const FaceRun& run : face.runs)
    left = std::min(left, run.first), right = std::max(right, run.end);
  const int top = face.runs.front().row;
  return {left, top, right - left, face.runs.back().row + 1 - top};
}

double change_at(const LightBlock& block, const Terms& terms) {
  return light_basis(block.s, block.t).dot(terms);
}

/// Bucket sort: most numbers lie close together, so narrow bins are sorted one by one.
std::vector<double> ascending(const std::vector<double>& values) {
  constexpr std::size_t kBins = 1024;
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  const double low = *lowest, per_value = (kBins - 1) / std::max(*highest - low, 1e-12);
  const auto bin_of = [&](double value) {
    return static_cast<std::size_t>((value - low) * per_value);
  };
  std::array<std::uint32_t, kBins + 1> end{};  // of each bin's numbers; first where they begin
  for (const double value : values) ++end[bin_of(value) + 1];
  for (std::size_t bin = 1; bin <= kBins; ++bin) end[bin] += end[bin - 1];
  std::vector<double> sorted(values.size());
  for (const double value : values) sorted[end[bin_of(value)]++] = value;
  std::uint32_t begin = 0;
  for (std::size_t bin = 0; bin < kBins; begin = end[bin++])
    if (end[bin] - begin > 1) std::sort(sorted.begin() + begin, sorted.begin() + end[bin]);
  return sorted;
}

/// Middle and length of the brightest interval that holds a fifth of the ratios and is not much
/// longer than the shortest. Contact-free skin has uniform ratios, and a contact of any width is
/// darker.
std::pair<double, double> untouched_ratio(const LightBlocks& blocks) {
  const std::vector<double> ratios = ascending(blocks.ratios());
  const std::size_t held = ratios.size() / 5;
  const auto length = [&](std::size_t first) { return ratios[first + held] - ratios[first]; };
  std::size_t shortest = 0, brightest = 0;
  for (std::size_t i = 0; i + held < ratios.size(); ++i)
    if (length(i) < length(shortest)) shortest = i;
  for (std::size_t i = 0; i + held < ratios.size(); ++i)
    if (length(i) <= kAlike * length(shortest)) brightest = i;
  return {0.5 * (ratios[brightest] + ratios[brightest + held]), length(brightest)};
}

double ramp(double value, double from, double to) {
  return std::clamp((value - from) / (to - from), 1e-3, 1.0);
}

/// One step of the re-weighted least squares; returns the inlier fraction of the blocks.
double refit(const LightBlocks& blocks, double widening, double inlier_fraction, Terms* terms,
             LightGain::Covariance* information) {
  auto [normal, pull, weights] = blocks.equations(*terms, kTukey, widening);
  normal.diagonal()[0] += 1.0 / (kConstantSd * kConstantSd);
  const double tilt_sd = kShapeSd * ramp(inlier_fraction, 0.2, 0.5),
               bow_sd = kShapeSd * ramp(inlier_fraction, 0.35, 0.65);
  for (int k = 1; k < LightGain::kTerms; ++k) {
    const double sd = k < 3 ? tilt_sd : bow_sd;
    normal.diagonal()[k] += 1.0 / (sd * sd);
  }
  *terms = normal.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
  *information = normal;
  return weights / static_cast<double>(blocks.size());
}

/// Noise ratio from the skin that is brighter than its reference, where no contact is. Half of a
/// normal distribution's magnitudes lie below 0.6745 sd. Errors of the reference are subtracted.
/// `promised`: expected noise as a fraction of the blocks' noise.
double noise_ratio(const LightBlocks& blocks, const Terms& terms, double expected_noise) {
  std::vector<double> above, floors;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const LightBlock block = blocks[i];
    const double z = (block.ratio * (1.0 + change_at(block, terms)) - 1.0) / block.noise;
    if (!(z > 0.0)) continue;
    above.push_back(z);
    floors.push_back(kFloor / block.noise);
  }
  if (static_cast<int>(above.size()) < kMinBlocks) return 1.0;
  const double all = upper_median(above) / 0.6745, floor = upper_median(floors);
  return std::sqrt(std::max(1.0, (all * all - floor * floor) / (expected_noise * expected_noise)));
}

/// Factor that corrects the covariance of a fit to independent blocks: noise is `ratio` times the
/// assumed one, and errors of the reference are correlated over patches of the face.
double covariance_factor(const LightBlocks& blocks, double ratio) {
  std::vector<double> noises = blocks.noises();
  const double more = std::max(1.0, ratio), one = upper_median(noises);
  const double noise = ratio * one, weighed = more * one;
  const double shared = std::max(1.0, static_cast<double>(blocks.size()) / kPatches);
  return more * more *
         ((noise * noise + shared * kFloor * kFloor) / (weighed * weighed + kFloor * kFloor));
}

/// Blocks that are clearly brighter than their reference under the light of `terms`.
LightBlocks brighter_blocks(const LightBlocks& blocks, const Terms& terms) {
  LightBlocks brighter;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const LightBlock block = blocks[i];
    const double above = block.ratio * (1.0 + change_at(block, terms)) - 1.0;
    if (above > kBrighter + 5.0 * block.sd) brighter.add(block);
  }
  return brighter;
}

struct LightFit {
  Terms terms = Terms::Zero();
  LightGain::Covariance covariance = LightGain::Covariance::Zero();
  double inlier_fraction = 0.5;  ///< fraction of the blocks
  LightBlocks brighter;          ///< see brighter_blocks()
  double brighter_part = 0;      ///< fraction of the blocks
};

/// Fits all `blocks`, starting from the common ratio of `untouched`.
std::optional<LightFit> fit_light(const LightBlocks& blocks, const LightBlocks& untouched) {
  const auto [ratio, spread] = untouched_ratio(untouched);
  if (!(ratio > 0.0)) return std::nullopt;
  LightFit fit;
  LightGain::Covariance information;
  fit.terms[0] = 1.0 / ratio - 1.0;
  // From wide to narrow: a change that tilts over the face must not be taken for a contact.
  double widening = spread;
  while (widening > 0.5 * kFloor) {
    fit.inlier_fraction = refit(blocks, widening, fit.inlier_fraction, &fit.terms, &information);
    widening *= 0.5;
  }
  for (int last = 0; last < 2; ++last)
    fit.inlier_fraction = refit(blocks, 0.0, fit.inlier_fraction, &fit.terms, &information);
  fit.covariance =
      information.selfadjointView<Eigen::Lower>().ldlt().solve(LightGain::Covariance::Identity());
  if (!fit.terms.allFinite() || !fit.covariance.allFinite()) return std::nullopt;
  fit.brighter = brighter_blocks(blocks, fit.terms);
  fit.brighter_part = static_cast<double>(fit.brighter.size()) / static_cast<double>(blocks.size());
  return fit;
}

/// Contacts only darken. Where the first light makes another part brighter and that part fits a
/// light of its own, the second one is the light and most of the face is pressed. On a different
/// finger the brighter parts have no common light.
LightFit brightest_light(const LightBlocks& blocks, LightFit first) {
  if (first.brighter_part < kMuchBrighter || static_cast<int>(first.brighter.size()) < kMinBlocks)
    return first;
  const auto second = fit_light(blocks, first.brighter);
  const bool is_true_light = second && second->inlier_fraction > kAgreeing * first.brighter_part &&
                             second->brighter_part < kLeftBrighter;
  return is_true_light ? *second : first;
}

}  // namespace

LightGain::LightGain(const cv::Rect& face, const std::array<double, kTerms>& terms,
                     double inlier_fraction, double brighter, double noise_ratio,
                     const Covariance& covariance)
    : terms_(terms),
      middle_u_(face.x + 0.5 * face.width),
      middle_v_(face.y + 0.5 * face.height),
      half_u_(0.5 * face.width),
      half_v_(0.5 * face.height),
      inlier_fraction_(inlier_fraction),
      brighter_(brighter),
      noise_ratio_(noise_ratio),
      covariance_(covariance) {}

std::array<float, 3> LightGain::of_row(int v) const {
  const double t = (v - middle_v_) / half_v_, m = middle_u_ / half_u_;
  // In powers of s = u / half - m first.
  const double a = 1.0 + terms_[0] + terms_[2] * t + terms_[5] * t * t,
               b = terms_[1] + terms_[4] * t, c = terms_[3];
  return {static_cast<float>(a - b * m + c * m * m),
          static_cast<float>((b - 2.0 * c * m) / half_u_),
          static_cast<float>(c / (half_u_ * half_u_))};
}

double LightGain::at(double u, double v) const {
  const double s = (u - middle_u_) / half_u_, t = (v - middle_v_) / half_v_;
  return 1.0 + light_basis(s, t).dot(Eigen::Map<const Terms>(terms_.data()));
}

double LightGain::sd_at(double u, double v) const {
  const Terms basis = light_basis((u - middle_u_) / half_u_, (v - middle_v_) / half_v_);
  return std::sqrt(std::max(0.0, basis.dot(covariance_ * basis)));
}

LightGain light_gain(const cv::Mat& grey, const ReferenceImage& reference, const FaceRuns& face,
                     double noise_sd, double noise_gain, std::optional<double> estimated_sd) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.size());
  const cv::Rect bounds = bounds_of(face);
  if (bounds.empty()) return {};
  const LightBlocks blocks =
      light_blocks(grey, reference, face, bounds, kTargetBlocks, noise_sd, noise_gain, kFloor);
  if (static_cast<int>(blocks.size()) < kMinBlocks) return {};
  auto first = fit_light(blocks, blocks);
  if (!first) return {};
  const LightFit fit = brightest_light(blocks, std::move(*first));
  std::array<double, LightGain::kTerms> values;
  std::copy(fit.terms.begin(), fit.terms.end(), values.begin());
  const double expected_noise = estimated_sd.value_or(noise_sd) / noise_sd;
  const double ratio_of_noise = noise_ratio(blocks, fit.terms, expected_noise);
  return {bounds,
          values,
          fit.inlier_fraction,
          fit.brighter_part,
          ratio_of_noise,
          covariance_factor(blocks, expected_noise * ratio_of_noise) * fit.covariance};
}

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

ALLTACT_WIDE void add_blocks(const LaneBlocks& first, std::size_t count, const double* c,
                             double tukey2, double widening2, double* __restrict sums) {
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
  return static_cast<std::size_t>(std::ptrdiff_t{degree} * (degree + 1) / 2 + t);
}

/// Brightnesses of a row that can be compared, 0 elsewhere, and a flag for each.
ALLTACT_WIDE void compare_row(const std::uint8_t* __restrict grey,
                              const std::int16_t* __restrict untouched, int count,
                              std::int32_t* __restrict live, std::int32_t* __restrict reference,
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

LightEquations LightBlocks::equations(const LightTerms& terms, double tukey,
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

LightBlocks light_blocks(const cv::Mat& grey, const ReferenceImage& reference, const FaceRuns& face,
                         const cv::Rect& bounds, double block_count, double noise_sd,
                         double noise_gain, double floor) {
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
      compare_row(grey.ptr<std::uint8_t>(v) + run.first, untouched + run.first, run.size(),
                  lives.data(), references.data(), counts.data());
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
        blocks.add({s, (v - bounds.y) / half_v - 1.0, sum / level, sd,
                    std::sqrt(sd * sd + floor * floor)});
      }
    }
  }
  return blocks;
}

}  // namespace alltact
