#include "calibration/joint/starting_curve.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace alltact {
namespace {

/// Nearly the largest of some differences: a few may be outliers.
double largest_of(std::vector<double> x) {
  if (x.empty()) return 0.0;
  const auto at =
      x.begin() + static_cast<std::ptrdiff_t>(0.995 * (static_cast<double>(x.size()) - 1));
  std::nth_element(x.begin(), at, x.end());
  return *at;
}

}  // namespace

double domain_of(const ChoiceInput& input, MappingAlong along) {
  double x_max = 0;
  if (input.steps != nullptr)
    for (const StepSamples& step : *input.steps) {
      std::vector<double> x;
      for (const Sample& sample : step.samples.samples) x.push_back(sample.x);
      x_max = std::max(x_max, largest_of(std::move(x)));
    }
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const ContactDisc disc(*input.presses[i], along, input.centres_mm[i]);
    std::vector<double> x;
    for (const Sample& sample : input.presses[i]->samples)
      if (disc.position_of(sample).radius < kInnerZone) x.push_back(sample.x);
    x_max = std::max(x_max, largest_of(std::move(x)));
  }
  return std::min(x_max, 1.0);
}

JointFit straight_start(const ChoiceInput& input, MappingAlong along, double x_max) {
  JointFit fit{MappingCurve({MappingKind::kPolynomial, 1}, x_max), input.centres_mm};
  double xd = 0, xx = 0;
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const ContactDisc disc(*input.presses[i], along, input.centres_mm[i]);
    for (const Sample& sample : input.presses[i]->samples) {
      if (disc.position_of(sample).radius > kInnerZone) continue;
      const double depth =
          ball_depth_mm(sample, along, input.centres_mm[i], input.presses[i]->ball_radius_mm);
      if (!std::isfinite(depth)) continue;
      xd += sample.x * depth;
      xx += sample.x * sample.x;
    }
  }
  fit.curve.set_line(xx > 0.0 && xd > 0.0 ? xd / xx : 1.0);
  return fit;
}

JointFit as_family(const JointFit& fit, CurveFamily family) {
  if (fit.curve.family() == family) return fit;
  MappingCurve curve(family, fit.curve.x_max());
  if (fit.curve.family() == kMoebiusFamily && family == kLayerFamily) {
    curve.values().head<2>() = fit.curve.values();
    return {curve, fit.centres_mm, false, fit.lift_mm};
  }
  if (fit.curve.family().kind == family.kind &&
      fit.curve.values().size() <= curve.values().size() &&
      fit.curve.family().coefficients == family.coefficients) {
    curve.values().head(fit.curve.values().size()) = fit.curve.values();
    return {curve, fit.centres_mm, false, fit.lift_mm};
  }
  curve.set_line(fit.curve.depth_mm(fit.curve.x_max()) / fit.curve.x_max());
  return {curve, fit.centres_mm, false, fit.lift_mm};
}

}  // namespace alltact
