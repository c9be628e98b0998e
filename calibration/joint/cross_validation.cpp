#include "calibration/joint/cross_validation.h"

#include "calibration/joint/stored_curve.h"
#include "calibration/verdict/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace alltact {
namespace {

constexpr double kTiePart = 0.1;  // of the better one: errors closer than this are the same

}  // namespace

HeldOutPresses hold_out(const ChoiceInput& input,
                        const JointFit& all,
                        const JointOptions& options,
                        const Job& job) {
  HeldOutPresses result;
  for (std::size_t left = 0; left < input.presses.size() && !job.stop_requested(); ++left) {
    std::vector<const PressSamples*> others;
    JointFit fit{all.curve, {}, false, all.lift_mm};
    for (std::size_t i = 0; i < input.presses.size(); ++i) {
      if (i == left) continue;
      others.push_back(input.presses[i]);
      fit.centres_mm.push_back(all.centres_mm[i]);
    }
    fit = fit_jointly(others, std::move(fit), options, job);
    // The ball by the part that surely touches it: what the rim does is not the mapping's shape.
    JointOptions alone = options;
    alone.fix_mapping = true;
    alone.zone = kSureZone;
    const std::vector<const PressSamples*> one{input.presses[left]};
    const JointFit ball =
        fit_jointly(one, {fit.curve, {all.centres_mm[left]}, false, fit.lift_mm}, alone, job);
    const bool is_good = fit.converged && ball.converged && increases(fit.curve, options.along);
    result.errors_mm.push_back(is_good ? quality_of(one, ball, alone).residual_mm.front()
                                       : std::numeric_limits<double>::infinity());
    result.curves.push_back(std::move(fit.curve));
  }
  return result;
}

double spread_of(const std::vector<MappingCurve>& curves) {
  const auto n = static_cast<double>(curves.size());
  if (curves.size() < 2) return 0;
  double spread = 0;
  for (int i = 1; i <= kDomainPlaces; ++i) {
    const double x = curves.front().x_max() * i / kDomainPlaces;
    double mean = 0, squares = 0;
    for (const MappingCurve& curve : curves) mean += curve.depth_mm(x) / n;
    for (const MappingCurve& curve : curves) squares += std::pow(curve.depth_mm(x) - mean, 2);
    spread += kMeanOfSd * std::sqrt(squares * (n - 1) / n) / kDomainPlaces;
  }
  return spread;
}

double mean_mm(const std::vector<double>& values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  return mean;
}

Excess excess_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += (a[i] - b[i]) / n;
  double variance = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    variance += (a[i] - b[i] - mean) * (a[i] - b[i] - mean) / (n - 1.0);
  return {mean, std::sqrt(variance / n)};
}

bool as_good(const std::vector<double>& a, const std::vector<double>& b) {
  const Excess excess = excess_of(a, b);
  return excess.mean <= std::max({kTieMm, kTiePart * mean_mm(b), excess.standard_error});
}

}  // namespace alltact
