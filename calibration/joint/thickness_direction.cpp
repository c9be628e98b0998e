#include "calibration/joint/thickness_direction.h"

#include "calibration/joint/cross_validation.h"
#include "calibration/joint/stored_curve.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace alltact {
namespace {

/// Held-out errors with the thickness in direction `along`. All directions use one zone of the
/// contacts, or their rims would decide.
std::vector<double> held_out_along(const ChoiceInput& input,
                                   CurveFamily family,
                                   MappingAlong along,
                                   const Job& job) {
  constexpr double kZone = 0.75;
  JointOptions options;
  options.along = along;
  options.zone = kZone;
  options.settled_mm = kSettledMm;
  options.steps = input.steps;
  options.max_rounds = input.max_rounds;
  const double x_max = domain_of(input, along);
  if (!(x_max > 0.0)) return {};
  const JointFit start =
      fit_jointly(input.presses, straight_start(input, along, x_max), options, job);
  const JointFit fit = fit_jointly(input.presses, as_family(start, family), options, job);
  if (!fit.converged || !increases(fit.curve, along)) return {};
  return hold_out(input, fit, options, job).errors_mm;
}

double finite_mean_mm(std::vector<double> errors) {
  std::erase_if(errors, [](double e) { return !std::isfinite(e); });
  return mean_mm(errors);
}

/// Whether errors a are larger than b, and not by chance, on the presses with both errors. The
/// excess depends on a press's incline, so the scatter between presses is more than chance.
bool is_significantly_worse(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kPart = 0.25;  // of the better one
  std::vector<double> a_finite, b_finite;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) && std::isfinite(b[i]))
      a_finite.push_back(a[i]), b_finite.push_back(b[i]);
  if (a_finite.size() < 2) return false;
  const Excess excess = excess_of(a_finite, b_finite);
  return excess.mean > std::max({kTieMm, kPart * mean_mm(b_finite), excess.standard_error});
}

/// Distance along the face between the contact positions by the two directions, mean over the
/// presses, mm.
double separation_mm(const ChoiceInput& input) {
  double sum = 0;
  for (std::size_t i = 0; i < input.presses.size(); ++i)
    if (const Sample* sample = nearest_sample(*input.presses[i], input.centres_mm[i])) {
      const Eigen::Vector3d off = sample->untouched_z - sample->untouched_n;
      sum += (off - off.dot(sample->normal) * sample->normal).norm();
    }
  return sum / static_cast<double>(input.presses.size());
}

}  // namespace

MappingAlong choose_along(const ChoiceInput& input,
                          CurveFamily family,
                          Message* remark,
                          const Job& job) {
  const auto by_normal = held_out_along(input, family, MappingAlong::kNormal, job);
  MappingAlong chosen = MappingAlong::kNormal;
  std::vector<double> best = by_normal;
  std::vector<double> rival;  // of another direction that is not significantly worse
  for (const MappingAlong along : {MappingAlong::kZ, MappingAlong::kProjected}) {
    const auto other = held_out_along(input, family, along, job);
    if (job.stop_requested() || other.size() < input.presses.size()) continue;
    if (!best.empty() && !is_significantly_worse(best, other)) {
      if (!is_significantly_worse(other, best)) rival = other;
      continue;
    }
    chosen = along;
    best = other;
  }
  const Message direction = chosen == MappingAlong::kZ
                                ? en::say("along z")
                                : en::say("along z projected onto its normal");
  if (chosen != MappingAlong::kNormal && !by_normal.empty())
    *remark = en::say(
        "brightness follows the layer's thickness {}: {:.4f} mm on presses left out, against "
        "{:.4f} mm along its normal",
        direction,
        finite_mean_mm(best),
        finite_mean_mm(by_normal));
  if (chosen == MappingAlong::kNormal && !by_normal.empty() && !rival.empty())
    *remark = en::say(
        "the presses do not tell whether brightness follows the layer's thickness along its normal "
        "({:.4f} mm on presses left out) or along z ({:.4f} mm): the normal is taken, and if that "
        "is wrong, places on the face lie {:.1f} mm off along it; larger pictures tell, and "
        "presses "
        "where the face is steep and where it is flat",
        finite_mean_mm(by_normal),
        finite_mean_mm(rival),
        separation_mm(input));
  return chosen;
}

}  // namespace alltact
