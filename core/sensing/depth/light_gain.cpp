#include "core/sensing/depth/light_gain.h"

#include "core/numerics/median.h"
#include "core/sensing/depth/light_blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kBlocks = 600;      // enough for six numbers, few enough to cost little
constexpr double kFloor = 0.002;     // what references are off by apart from noise
constexpr double kTukey = 4.0;       // sigmas beyond which a block says nothing
constexpr double kConstantSd = 0.5;  // what changes are to be expected
constexpr double kShapeSd = 0.05;
constexpr double kAlike = 2.0;   // times the shortest stretch of ratios
constexpr double kPatches = 30;  // of the face, over each of which references are off alike
constexpr int kLeastBlocks = 20;
constexpr double kBrighter = 0.05;  // than any halo around a contact
// A second light, told by what the first makes brighter than its reference: from such a part of the
// face on it is looked for, such a part of that must agree on it, and it must leave no more over.
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

/// Sorts numbers most of which lie close together: into narrow bins first, then each of these.
std::vector<double> ascending(const std::vector<double>& values) {
  constexpr std::size_t kBins = 1024;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double low = *least, per_value = (kBins - 1) / std::max(*most - low, 1e-12);
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

/// The middle and half the length of the brightest stretch of ratios that holds a fifth of them and
/// is not much longer than the shortest that does: untouched skin looks alike, and what presses on
/// it, however wide, is darker.
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

/// One step of the re-weighted least squares; gives the part of the blocks that is believed.
double refit(const LightBlocks& blocks,
             double widening,
             double believed,
             Terms* terms,
             LightGain::Covariance* information) {
  auto [normal, pull, weights] = blocks.equations(*terms, kTukey, widening);
  normal.diagonal()[0] += 1.0 / (kConstantSd * kConstantSd);
  const double tilt_sd = kShapeSd * ramp(believed, 0.2, 0.5),
               bow_sd = kShapeSd * ramp(believed, 0.35, 0.65);
  for (int k = 1; k < LightGain::kTerms; ++k) {
    const double sd = k < 3 ? tilt_sd : bow_sd;
    normal.diagonal()[k] += 1.0 / (sd * sd);
  }
  *terms = normal.selfadjointView<Eigen::Lower>().ldlt().solve(pull);
  *information = normal;
  return weights / static_cast<double>(blocks.size());
}

/// From the skin that is brighter than its reference, where no contact is: half of a normal
/// distribution's magnitudes lie below 0.6745 sd. What references are off by is taken off.
/// `promised`: how noisy it is said to be, as a part of the blocks' noise.
double noise_ratio(const LightBlocks& blocks, const Terms& terms, double promised) {
  std::vector<double> above, floors;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const LightBlock block = blocks[i];
    const double z = (block.ratio * (1.0 + change_at(block, terms)) - 1.0) / block.noise;
    if (!(z > 0.0)) continue;
    above.push_back(z);
    floors.push_back(kFloor / block.noise);
  }
  if (static_cast<int>(above.size()) < kLeastBlocks) return 1.0;
  const double all = upper_median(above) / 0.6745, floor = upper_median(floors);
  return std::sqrt(std::max(1.0, (all * all - floor * floor) / (promised * promised)));
}

/// By what the covariance of a fit to independent blocks, as noisy as they were weighed, falls
/// short: noise is `ratio` times that, and what references are off by is alike over patches of the
/// face.
double shortfall(const LightBlocks& blocks, double ratio) {
  std::vector<double> noises = blocks.noises();
  const double more = std::max(1.0, ratio), one = upper_median(noises);
  const double noise = ratio * one, weighed = more * one;
  const double shared = std::max(1.0, static_cast<double>(blocks.size()) / kPatches);
  return more * more *
         ((noise * noise + shared * kFloor * kFloor) / (weighed * weighed + kFloor * kFloor));
}

/// The blocks that are clearly brighter than their reference under the light of `terms`.
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
  double believed = 0.5;     ///< part of the blocks
  LightBlocks brighter;      ///< see brighter_blocks()
  double brighter_part = 0;  ///< of the blocks
};

/// Fits all `blocks`, starting from the ratio that `untouched` have in common.
std::optional<LightFit> fit_light(const LightBlocks& blocks, const LightBlocks& untouched) {
  const auto [ratio, spread] = untouched_ratio(untouched);
  if (!(ratio > 0.0)) return std::nullopt;
  LightFit fit;
  LightGain::Covariance information;
  fit.terms[0] = 1.0 / ratio - 1.0;
  // From wide to narrow: a change that tilts over the face must not look like a contact.
  double widening = spread;
  while (widening > 0.5 * kFloor) {
    fit.believed = refit(blocks, widening, fit.believed, &fit.terms, &information);
    widening *= 0.5;
  }
  for (int last = 0; last < 2; ++last)
    fit.believed = refit(blocks, 0.0, fit.believed, &fit.terms, &information);
  fit.covariance =
      information.selfadjointView<Eigen::Lower>().ldlt().solve(LightGain::Covariance::Identity());
  if (!fit.terms.allFinite() || !fit.covariance.allFinite()) return std::nullopt;
  fit.brighter = brighter_blocks(blocks, fit.terms);
  fit.brighter_part = static_cast<double>(fit.brighter.size()) / static_cast<double>(blocks.size());
  return fit;
}

/// What presses only darkens. Where the light that most of the face tells makes another part
/// brighter, and that part agrees on a light of its own, that one is the light and most of the face
/// is pressed. On another finger the brighter parts do not agree.
LightFit brightest_light(const LightBlocks& blocks, LightFit first) {
  if (first.brighter_part < kMuchBrighter || static_cast<int>(first.brighter.size()) < kLeastBlocks)
    return first;
  const auto second = fit_light(blocks, first.brighter);
  const bool is_the_light = second && second->believed > kAgreeing * first.brighter_part &&
                            second->brighter_part < kLeftBrighter;
  return is_the_light ? *second : first;
}

}  // namespace

LightGain::LightGain(const cv::Rect& face,
                     const std::array<double, kTerms>& terms,
                     double believed,
                     double brighter,
                     double noise_ratio,
                     const Covariance& covariance)
    : terms_(terms),
      middle_u_(face.x + 0.5 * face.width),
      middle_v_(face.y + 0.5 * face.height),
      half_u_(0.5 * face.width),
      half_v_(0.5 * face.height),
      believed_(believed),
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

LightGain light_gain(const cv::Mat& grey,
                     const ReferencePicture& reference,
                     const FaceRuns& face,
                     double noise_sd,
                     double noise_gain,
                     std::optional<double> told_sd) {
  CV_Assert(grey.type() == CV_8UC1 && grey.size() == reference.size());
  const cv::Rect bounds = bounds_of(face);
  if (bounds.empty()) return {};
  const LightBlocks blocks =
      light_blocks(grey, reference, face, bounds, kBlocks, noise_sd, noise_gain, kFloor);
  if (static_cast<int>(blocks.size()) < kLeastBlocks) return {};
  auto first = fit_light(blocks, blocks);
  if (!first) return {};
  const LightFit fit = brightest_light(blocks, std::move(*first));
  std::array<double, LightGain::kTerms> values;
  std::copy(fit.terms.begin(), fit.terms.end(), values.begin());
  const double promised = told_sd.value_or(noise_sd) / noise_sd;
  const double ratio_of_noise = noise_ratio(blocks, fit.terms, promised);
  return {bounds,
          values,
          fit.believed,
          fit.brighter_part,
          ratio_of_noise,
          shortfall(blocks, promised * ratio_of_noise) * fit.covariance};
}

}  // namespace alltact
