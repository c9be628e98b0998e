#include "calibration/joint/contact_zone.h"

#include "calibration/joint/lift_off.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kQuietRingMm = 0.002;  // mean residual of a ring that is always accepted
constexpr double kRingExcess = 1.5;     // times the scatter of a ring's sectors
constexpr double kSmallSd = 0.01;       // of the depth: small enough a standard deviation by chance
// of the rim's radius: the skin is not exactly that membrane
constexpr double kContactMargin = 0.03;

/// Standard deviation of the depth at the end of the domain, as a fraction of that depth.
double relative_depth_sd(const JointFit& fit, const Eigen::MatrixXd& all) {
  if (all.size() == 0) return std::numeric_limits<double>::infinity();
  Eigen::VectorXd gradient(fit.curve.values().size());
  const double depth = fit.curve.depth_mm(fit.curve.x_max(), gradient.data());
  const auto n = gradient.size();
  return std::sqrt(std::max(0.0, gradient.dot(all.topLeftCorner(n, n) * gradient))) / depth;
}

/// Whether the mean residuals of the rings, common to all presses, are chance, and the skin has
/// lifted off so little that its form does not matter.
bool rings_agree(const FitQuality& quality) {
  const double chance_mm = std::max(kQuietRingMm, kRingExcess * quality.scatter_mm);
  return quality.ring_mm <= chance_mm && quality.lifted_sd_mm <= kQuietRingMm;
}

/// Mean over presses of the contact radius, where the skin leaves the ball, over the rim's radius.
double contact_fraction(const ChoiceInput& input, const JointFit& fit) {
  double sum = 0;
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const PressSamples& press = *input.presses[i];
    const double radius = press.ball_radius_mm,
                 height = plane_below(press, fit.centres_mm[i]).height_mm(fit.centres_mm[i]);
    const double rim2 = std::max(1e-6, (radius - height) * (radius + height));
    sum += contact_radius_mm(rim2, fit.lift_mm) / std::sqrt(rim2);
  }
  return sum / static_cast<double>(input.presses.size());
}

Message inner_sentence(double zone) {
  return en::say(
      "the inner {:.0f} % of each contact's radius was used, where the skin surely touches the "
      "ball",
      100.0 * zone);
}

}  // namespace

JointFit choose_zone(const ChoiceInput& input,
                     JointFit fit,
                     JointOptions* options,
                     Message* remark,
                     const Job& job) {
  options->zone = kInnerZone;
  fit = fit_jointly(input.presses, as_family(fit, kLayerFamily), *options, job);
  *remark = inner_sentence(options->zone);
  // Any skin is in contact there. The zone further out is read only where it is needed.
  if (relative_depth_sd(fit, chance_covariance_of(input.presses, fit, *options).covariance) <
      kSmallSd)
    return fit;
  const double inner_part =
      relative_depth_sd(fit, covariance_of(input.presses, fit, *options).covariance);
  JointFit start = fit;
  start.lift_mm = kTypicalLiftMm;
  JointOptions wider = *options;
  wider.zone = 1.0;
  wider.free_lift = true;
  const double touching = contact_fraction(input, fit_jointly(input.presses, start, wider, job));
  for (const double zone : {1.0, 0.93, 0.85, 0.75}) {
    if (zone > touching - kContactMargin) continue;
    wider.zone = zone;
    const JointFit next = fit_jointly(input.presses, start, wider, job);
    if (job.stop_requested()) break;
    const FitQuality quality = quality_of(input.presses, next, wider);
    if (!next.converged || !rings_agree(quality)) continue;
    const double part =
        relative_depth_sd(next, covariance_of(input.presses, next, wider).covariance);
    if (part >= inner_part) continue;
    *options = wider;
    // Further in the length has no effect and stays at its prior.
    constexpr double kShownMm = 1e-4;
    *remark = quality.lifted_sd_mm > kShownMm
                  ? en::say(
                        "the inner {:.0f} % of each contact's radius was used; the skin comes back "
                        "from the ball over {:.2f} mm",
                        100.0 * zone,
                        next.lift_mm)
                  : inner_sentence(zone);
    return next;
  }
  return fit;
}

}  // namespace alltact
