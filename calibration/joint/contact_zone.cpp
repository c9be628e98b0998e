#include "calibration/joint/contact_zone.h"

#include "calibration/joint/lift_off.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kQuietRingMm = 0.002;    // mean residual of a ring that is never held against it
constexpr double kRingExcess = 1.5;       // times the scatter of a ring's sectors
constexpr double kCertainPart = 0.01;     // of the depth: what chance leaves open is little enough
constexpr double kShortOfContact = 0.03;  // of the rim's radius: no skin is quite that membrane

/// What a covariance leaves uncertain of the depth at the end of the domain, as a part of it.
double uncertain_part(const JointFit& fit, const Eigen::MatrixXd& all) {
  if (all.size() == 0) return std::numeric_limits<double>::infinity();
  Eigen::VectorXd gradient(fit.curve.values().size());
  const double depth = fit.curve.depth_mm(fit.curve.x_max(), gradient.data());
  const auto n = gradient.size();
  return std::sqrt(std::max(0.0, gradient.dot(all.topLeftCorner(n, n) * gradient))) / depth;
}

/// Whether what the rings of a contact are off by, in all presses alike, is chance, and so little
/// of them has lifted off that its form does not matter.
bool rings_agree(const FitQuality& quality) {
  const double chance_mm = std::max(kQuietRingMm, kRingExcess * quality.scatter_mm);
  return quality.ring_mm <= chance_mm && quality.lifted_sd_mm <= kQuietRingMm;
}

/// Which part of their rims' radius the contacts reach before the skin leaves the ball, on average.
double touching_part(const ChoiceInput& input, const JointFit& fit) {
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
  options->zone = kSureZone;
  fit = fit_jointly(input.presses, as_family(fit, kLayerFamily), *options, job);
  *remark = inner_sentence(options->zone);
  // Any skin touches there: what it does further out is read only where it is needed.
  if (uncertain_part(fit, chance_covariance_of(input.presses, fit, *options).covariance) <
      kCertainPart)
    return fit;
  const double inner_part =
      uncertain_part(fit, covariance_of(input.presses, fit, *options).covariance);
  JointFit start = fit;
  start.lift_mm = kUsualLiftMm;
  JointOptions wider = *options;
  wider.zone = 1.0;
  wider.free_lift = true;
  const double touching = touching_part(input, fit_jointly(input.presses, start, wider, job));
  for (const double zone : {1.0, 0.93, 0.85, 0.75}) {
    if (zone > touching - kShortOfContact) continue;
    wider.zone = zone;
    const JointFit next = fit_jointly(input.presses, start, wider, job);
    if (job.stop_requested()) break;
    const FitQuality quality = quality_of(input.presses, next, wider);
    if (!next.converged || !rings_agree(quality)) continue;
    const double part = uncertain_part(next, covariance_of(input.presses, next, wider).covariance);
    if (part >= inner_part) continue;
    *options = wider;
    // Further in the length shows in nothing, and is what it was believed to be.
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
