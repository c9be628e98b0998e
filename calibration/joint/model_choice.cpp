#include "calibration/joint/model_choice.h"

#include "calibration/joint/contact_zone.h"
#include "calibration/joint/cross_validation.h"
#include "calibration/joint/stored_curve.h"
#include "calibration/joint/thickness_direction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kInclineDeg = 3.0;  // needed to separate thickness along z from along the normal
constexpr int kMaxCoefficients = 6;
constexpr std::size_t kVaryingPresses = 5;  // two more numbers need two more presses

std::vector<CurveFamily> families_for(const CalibrationSettings& settings, std::size_t presses) {
  const bool is_single = presses < 2;
  std::vector<CurveFamily> families;
  const auto polynomial = [&](int n) { families.push_back({MappingKind::kPolynomial, n}); };
  if (settings.family == FamilyChoice::kMoebius) return {kMoebiusFamily};
  if (settings.family == FamilyChoice::kLayer) return {kLayerFamily};
  if (settings.degree > 0) {
    // The user requested a degree: that polynomial.
    polynomial(settings.degree);
    return families;
  }
  if (settings.family == FamilyChoice::kPolynomial) {
    if (is_single) return {{MappingKind::kPolynomial, 2}, {MappingKind::kPolynomial, 1}};
    for (int n = 1; n <= kMaxCoefficients; ++n) polynomial(n);
    return families;
  }
  // One press does not determine absorption.
  if (is_single) return {kMoebiusFamily, {MappingKind::kPolynomial, 1}};
  // The curves of a scattering layer come first. A straight line and the Moebius curve are among
  // them. As separate families they would win ties, and the ball centres would take up their error
  // in scale.
  families.push_back(kLayerFamily);
  for (int n = 2; n <= kMaxCoefficients; ++n) polynomial(n);
  return families;
}

/// The steepest incline under any press. On a face normal to z both directions are the same.
double steepest_deg(const ChoiceInput& input) {
  double low = 1.0;
  for (const PressSamples* press : input.presses)
    for (const Sample& sample : press->samples) low = std::min(low, sample.cos_incline);
  return 180.0 / M_PI * std::acos(std::clamp(low, 0.0, 1.0));
}

/// Mean absolute distance over the domain between a curve and the one with one more number, fitted
/// to the same presses. All presses share the error of a family that is too simple, and the balls
/// take it up, so cross-validation does not show it.
double beyond_family_mm(const ChoiceInput& input,
                        const JointFit& fit,
                        const JointOptions& options,
                        const Job& job) {
  CurveFamily richer = fit.curve.family();
  if (richer.absorbs()) return 0;  // the covariance contains the error of its third number
  richer.kind = MappingKind::kPolynomial;
  if (++richer.coefficients > kMaxCoefficients) return 0;
  const JointFit other = fit_jointly(input.presses, as_family(fit, richer), options, job);
  if (!other.converged || !increases(other.curve, options.along)) return 0;
  double deviation = 0;
  for (int i = 1; i <= kDomainPoints; ++i) {
    const double x = fit.curve.x_max() * i / kDomainPoints;
    deviation += std::abs(other.curve.depth_mm(x) - fit.curve.depth_mm(x)) / kDomainPoints;
  }
  return deviation;
}

void store_errors(const HeldOutPresses& held_out, ModelChoice* choice) {
  choice->held_out_mm = held_out.errors_mm;
  choice->spread_mm = spread_of(held_out.curves);
}

struct Candidate {
  JointFit fit;
  HeldOutPresses held_out;
};

/// Fits the families, the simplest first, and returns those with an increasing curve and their
/// held-out errors (none with one press). It ends where more coefficients no longer help. One press
/// takes the first family that fits.
std::vector<Candidate> try_families(const ChoiceInput& input,
                                    const std::vector<CurveFamily>& families,
                                    const JointFit& start,
                                    const JointOptions& options,
                                    const Job& job) {
  constexpr int kMaxWorse = 3;
  std::vector<Candidate> candidates;
  double best_mm = std::numeric_limits<double>::infinity();
  int worse = 0;
  for (std::size_t i = 0; i < families.size() && worse < kMaxWorse; ++i) {
    if (job.stop_requested() && !candidates.empty()) break;
    job.report(static_cast<double>(i) / static_cast<double>(families.size()),
               en::say("trying a {}", families[i].name()));
    Candidate candidate{fit_jointly(input.presses, as_family(start, families[i]), options, job),
                        {}};
    if (!candidate.fit.converged || !increases(candidate.fit.curve, options.along)) continue;
    if (input.presses.size() < 2) return {std::move(candidate)};
    candidate.held_out = hold_out(input, candidate.fit, options, job);
    // Stopped during cross-validation; a single family needs no comparison.
    if (candidate.held_out.errors_mm.size() < input.presses.size() && families.size() > 1) break;
    const double error_mm = mean_mm(candidate.held_out.errors_mm);
    worse = error_mm < best_mm ? 0 : worse + 1;
    best_mm = std::min(best_mm, error_mm);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

/// Why `chosen` was taken, where `best` has the smallest held-out error.
Message why(const Candidate& chosen, const Candidate& best) {
  const Message name = chosen.fit.curve.family().name();
  const double error_mm = mean_mm(chosen.held_out.errors_mm);
  if (&chosen == &best)
    return en::at(name, en::say("least error on presses left out, {:.4f} mm", error_mm));
  return en::at(
      name,
      en::say(
          "{:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and "
          "simpler",
          error_mm,
          best.fit.curve.family().name(),
          mean_mm(best.held_out.errors_mm)));
}

/// The best of some families for one direction of the thickness.
std::optional<ModelChoice> choose_family(const ChoiceInput& input,
                                         const std::vector<CurveFamily>& families,
                                         MappingAlong along,
                                         const Job& job) {
  ModelChoice choice{{along}, straight_start(input, along, domain_of(input, along)), {}, 0, {}, {}};
  if (!(choice.fit.curve.x_max() > 0.0)) return std::nullopt;
  choice.options.zone = kInnerZone;
  choice.options.settled_mm = kSettledMm;
  choice.options.steps = input.steps;
  choice.options.max_rounds = input.max_rounds;
  JointFit start = fit_jointly(input.presses, choice.fit, choice.options, job);
  Message zone_remark;
  start = choose_zone(input, std::move(start), &choice.options, &zone_remark, job);
  choice.remarks.push_back(std::move(zone_remark));

  const auto candidates = try_families(input, families, start, choice.options, job);
  if (candidates.empty()) return std::nullopt;
  const auto best =
      std::min_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return mean_mm(a.held_out.errors_mm) < mean_mm(b.held_out.errors_mm);
      });
  const auto chosen = std::find_if(candidates.begin(), best, [&](const Candidate& one) {
    return is_no_worse(one.held_out.errors_mm, best->held_out.errors_mm);
  });
  choice.fit = chosen->fit;
  store_errors(chosen->held_out, &choice);
  const Message name = choice.fit.curve.family().name();
  choice.sentence = input.presses.size() < 2
                        ? en::at(name, en::say("with one press nothing can be held out"))
                    : families.size() == 1 ? en::at(name, en::say("as asked for"))
                                           : why(*chosen, *best);
  return choice;
}

/// The family by which directions of the thickness are compared.
CurveFamily comparing_family(const CalibrationSettings& settings,
                             const std::vector<CurveFamily>& families) {
  constexpr std::size_t kEnough = 2;  // of polynomials: of degree 3
  if (settings.family == FamilyChoice::kAuto && settings.degree == 0) return kLayerFamily;
  return families[std::min(kEnough, families.size() - 1)];
}

/// The direction of the thickness, and the best family for it.
std::optional<ModelChoice> choose_along_and_family(const ChoiceInput& input,
                                                   const CalibrationSettings& settings,
                                                   const Job& job) {
  const auto families = families_for(settings, input.presses.size());
  if (settings.along == AlongChoice::kZ)
    return choose_family(input, families, MappingAlong::kZ, job);
  if (settings.along == AlongChoice::kProjected)
    return choose_family(input, families, MappingAlong::kProjected, job);
  const bool is_separable = input.presses.size() > 1 && steepest_deg(input) > kInclineDeg;
  if (settings.along == AlongChoice::kNormal || !is_separable)
    return choose_family(input, families, MappingAlong::kNormal, job);
  Message remark;
  const MappingAlong along =
      choose_along(input, comparing_family(settings, families), &remark, job);
  auto choice = choose_family(input, families, along, job);
  if (choice && !remark.empty()) choice->remarks.push_back(std::move(remark));
  return choice;
}

/// Lets the mapping vary over the face where held-out presses agree better then.
void try_variation(const ChoiceInput& input, ModelChoice* choice, const Job& job) {
  if (input.presses.size() < kVaryingPresses || choice->held_out_mm.size() < kVaryingPresses)
    return;
  CurveFamily family = choice->fit.curve.family();
  family.varies = true;
  job.report(1.0, en::say("trying a {}", family.name()));
  Candidate varying{
      fit_jointly(input.presses, as_family(choice->fit, family), choice->options, job), {}};
  if (!varying.fit.converged || !increases(varying.fit.curve, choice->options.along)) return;
  varying.held_out = hold_out(input, varying.fit, choice->options, job);
  const std::vector<double>& errors = varying.held_out.errors_mm;
  if (errors.size() < choice->held_out_mm.size() || is_no_worse(choice->held_out_mm, errors))
    return;
  const Eigen::Vector2d part = varying.fit.curve.values().tail<2>();
  choice->remarks.push_back(en::say(
      "the mapping varies over the face, as uneven light or an uneven layer make it: by {:+.0f} % "
      "from the presses nearest to the base to those nearest to the tip, by {:+.0f} % from side to "
      "side; {:.4f} mm on presses left out, against {:.4f} mm with one mapping for all",
      200.0 * part.x(),
      200.0 * part.y(),
      mean_mm(errors),
      mean_mm(choice->held_out_mm)));
  choice->sentence = why(varying, varying);
  store_errors(varying.held_out, choice);
  choice->fit = varying.fit;
}

}  // namespace

std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                        const CalibrationSettings& settings,
                                        const Job& job) {
  auto choice = choose_along_and_family(input, settings, job);
  if (choice && settings.face_variation == FaceVariationChoice::kAuto)
    try_variation(input, &*choice, job);
  if (choice && input.presses.size() > 1 && !job.stop_requested())
    choice->spread_mm =
        std::hypot(choice->spread_mm, beyond_family_mm(input, choice->fit, choice->options, job));
  return choice;
}

}  // namespace alltact
