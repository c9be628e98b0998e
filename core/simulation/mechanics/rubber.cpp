#include "core/simulation/mechanics/rubber.h"

#include <algorithm>
#include <cmath>

namespace alltact {

Result<double> modulus_from_shore_a(double shore_a) {
  if (!(shore_a >= kSoftestShoreA && shore_a <= kHardestShoreA))
    return Error{en::say("a hardness of {:g} Shore A has no known modulus", shore_a), "",
                 en::say("{:g} to {:g}", kSoftestShoreA, kHardestShoreA)};
  return 0.0981 * (56 + 7.66 * shore_a) / (0.137505 * (254 - 2.54 * shore_a));
}

namespace {

// A unit's deflection after a step of h time constants: `decay` times its previous value, plus
// weights of the load at the step's two ends.
struct KelvinStep {
  double decay, from, to;
};

KelvinStep kelvin_step(double h) {
  if (h == 0) return {1, 0, 0};
  const double decay = std::exp(-h);
  // (1 - exp(-h)) / h, and 1 less that, without cancellation.
  const double mean = -std::expm1(-h) / h;
  const double to = h < 1e-2 ? h * (0.5 - h * (1.0 / 6 - h * (1.0 / 24 - h / 120))) : 1 - mean;
  return {decay, -std::expm1(-h) - to, to};
}

}  // namespace

double KelvinChain::compliance(double time_s) const {
  double sum = instant_;
  for (const KelvinUnit& unit : units_) sum -= unit.share * std::expm1(-time_s / unit.time_s);
  return sum;
}

double KelvinChain::memory_s() const {
  double longest_s = 0;
  for (const KelvinUnit& unit : units_) longest_s = std::max(longest_s, unit.time_s);
  return 40 * longest_s;
}

Eigen::Vector4d KelvinChain::History::before(double step_s) const {
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  for (std::size_t i = 0; i < units_.size(); ++i) {
    const KelvinUnit& unit = chain_->units_[i];
    const KelvinStep part = kelvin_step(step_s / unit.time_s);
    sum += part.decay * units_[i] + unit.share * part.from * elastic_;
  }
  return sum;
}

double KelvinChain::History::weight(double step_s) const {
  double sum = chain_->instant_;
  for (const KelvinUnit& unit : chain_->units_)
    sum += unit.share * kelvin_step(step_s / unit.time_s).to;
  return sum;
}

void KelvinChain::History::step(double step_s, const Eigen::Vector4d& elastic) {
  for (std::size_t i = 0; i < units_.size(); ++i) {
    const KelvinUnit& unit = chain_->units_[i];
    const KelvinStep part = kelvin_step(step_s / unit.time_s);
    units_[i] = part.decay * units_[i] + unit.share * (part.from * elastic_ + part.to * elastic);
  }
  elastic_ = elastic;
}

}  // namespace alltact
