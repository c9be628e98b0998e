#include "calibration/joint/contact_model.h"
#include "calibration/joint/joint_fit.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
namespace {

// Cross-validation: fits without one press after the other, their errors on the press left out, and
// a comparison of two such series.

constexpr int kDomainPoints = 12;  // of the curve, where curves are compared
// Held-out errors closer than this are ties. The balls take up ten times as much of a wrong scale
// as they leave visible, so noise must not decide.
constexpr double kTieMm = 0.001;
constexpr double kSettledMm = 1e-5;  // precise enough for a choice of the model
constexpr double kTiePart = 0.1;     // of the better error: closer errors are ties
// A family without physics behind it needs more than one standard error. By one, every twentieth
// layer got a polynomial, and with it a scale that is wrong by a tenth. Of six presses, chance
// exceeds 2.5 in one of forty cases (Student).
constexpr double kFamilyErrors = 2.5;

/// The contact's position on the face, by the ball fitted to it.
ContactSpot spot_of(const PressSamples& press, const Eigen::Vector3d& centre_mm) {
  const Sample* nearest = nearest_sample(press, centre_mm);
  if (nearest == nullptr) return {};
  const double height_mm = plane_below(press, centre_mm).height_mm(centre_mm);
  const double rim2 = (press.ball_radius_mm - height_mm) * (press.ball_radius_mm + height_mm);
  return {nearest->position_mm.x(), nearest->position_mm.y(), std::sqrt(std::max(0.0, rim2)), 0};
}

/// The position of each press, numbered from 0. With fewer than three positions each press has its
/// own: one press alone does not show the scale.
std::vector<int> positions_of(const ChoiceInput& input, const JointFit& all) {
  std::vector<ContactSpot> spots;
  for (std::size_t i = 0; i < input.presses.size(); ++i)
    spots.push_back(spot_of(*input.presses[i], all.centres_mm[i]));
  std::vector<int> positions = position_numbers(spots);
  constexpr int kFewest = 3;
  if (std::all_of(positions.begin(), positions.end(), [](int n) { return n + 1 < kFewest; }))
    std::iota(positions.begin(), positions.end(), 0);
  return positions;
}

/// The jackknife's mean absolute depth error of a curve over the domain; 0 for fewer than two
/// curves.
double spread_of(const std::vector<MappingCurve>& curves) {
  const auto n = static_cast<double>(curves.size());
  if (curves.size() < 2) return 0;
  double spread = 0;
  for (int i = 1; i <= kDomainPoints; ++i) {
    const double x = curves.front().x_max() * i / kDomainPoints;
    double mean = 0, squares = 0;
    for (const MappingCurve& curve : curves) mean += curve.depth_mm(x) / n;
    for (const MappingCurve& curve : curves) squares += std::pow(curve.depth_mm(x) - mean, 2);
    spread += kMeanOfSd * std::sqrt(squares * (n - 1) / n) / kDomainPoints;
  }
  return spread;
}

/// Presses whose contacts lie closer together than the larger one's radius share a position. They
/// are left out together, because a repeat would predict its likes. With fewer than three positions
/// each press is left out separately. One error for each press, fewer when the job was stopped.
/// Errors are infinite where the other presses gave no increasing curve: a family that one press
/// can lead astray is not reliable. An error is the mean absolute one, error_of_press(), of the
/// mapping fitted without the press's position. `all`: the fit of all presses, to start from.
/// `spread_mm` (may be null): spread_of() the fitted curves.
std::vector<double> hold_out(const ChoiceInput& input, const JointFit& all,
                             const JointOptions& options, const Job& job,
                             double* spread_mm = nullptr) {
  const std::vector<int> positions = positions_of(input, all);
  const int count =
      positions.empty() ? 0 : 1 + *std::max_element(positions.begin(), positions.end());
  std::vector<MappingCurve> curves(static_cast<std::size_t>(count), all.curve);  // by position
  std::vector<double> errors_mm(input.presses.size(), -1.0);
  const auto leave_out = [&](int left) {
    std::vector<const PressSamples*> others;
    JointFit fit{all.curve, {}, false, all.lift_mm};
    for (std::size_t i = 0; i < input.presses.size(); ++i) {
      if (positions[i] == left) continue;
      others.push_back(input.presses[i]);
      fit.centres_mm.push_back(all.centres_mm[i]);
    }
    fit = fit_jointly(others, std::move(fit), options, job);
    const bool is_good = fit.converged && increases(fit.curve, options.along);
    for (std::size_t i = 0; i < input.presses.size(); ++i)
      if (positions[i] == left)
        errors_mm[i] = is_good
                           ? error_of_press(*input.presses[i], fit, all.centres_mm[i], options, job)
                           : std::numeric_limits<double>::infinity();
    curves[static_cast<std::size_t>(left)] = std::move(fit.curve);
  };
  parallel_for(count, default_threads(), [&](int first, int last) {
    for (int left = first; left < last && !job.stop_requested(); ++left) leave_out(left);
  });
  if (spread_mm != nullptr) *spread_mm = spread_of(curves);
  // stopped before the others
  errors_mm.erase(std::find_if(errors_mm.begin(), errors_mm.end(), [](double e) { return e < 0; }),
                  errors_mm.end());
  return errors_mm;
}

double mean_mm(const std::vector<double>& values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  return mean;
}

/// Whether the errors `a` are no worse than `b` on the same presses: their mean excess is a tie, at
/// most `part` of the mean of b, or within so many of its standard errors.
bool is_no_worse(const std::vector<double>& a, const std::vector<double>& b, double part = kTiePart,
                 double standard_errors = 1.0) {
  const auto n = static_cast<double>(a.size());
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += (a[i] - b[i]) / n;
  double variance = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    variance += (a[i] - b[i] - mean) * (a[i] - b[i] - mean) / (n - 1.0);
  return mean <= std::max({kTieMm, part * mean_mm(b), standard_errors * std::sqrt(variance / n)});
}

// The choice.

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
      "the inner {:.0f} % of each contact's radius was used, where the skin touches the ball",
      100.0 * zone);
}

/// Whether more than balls in images is known: a measured depth, or another body.
bool knows_a_depth(const ChoiceInput& input) {
  return (input.shapes != nullptr && !input.shapes->empty()) ||
         std::any_of(input.presses.begin(), input.presses.end(),
                     [](const PressSamples* press) { return press->given_depth.has_value(); });
}

/// Fits as much of each contact as ball and lift-off explain, from the rim inwards, by the family
/// of layers. Stores the zone in `options`, and a sentence on it in `remark`. The inner zone alone
/// leaves an offset between balls and mapping open. A curve that is not quite the layer's takes
/// that offset up; near the rim it shows. The rim shows how far the skin follows the ball, but not
/// the form in which it leaves it. Where rings show a form that contact_model.h does not model, the
/// scale would take up ten times its error.
JointFit choose_zone(const ChoiceInput& input, JointFit fit, JointOptions* options, Message* remark,
                     const Job& job) {
  options->zone = kInnerZone;
  fit = fit_jointly(input.presses, as_family(fit, kLayerFamily), *options, job);
  *remark = inner_sentence(options->zone);
  // What is measured settles that offset. The fit weighs no errors common to samples, so those of
  // the rim would outvote it.
  if (knows_a_depth(input) &&
      relative_depth_sd(fit, chance_covariance_of(input.presses, fit, *options)) < kSmallSd)
    return fit;
  const double inner_part = relative_depth_sd(fit, covariance_of(input.presses, fit, *options));
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
    const double part = relative_depth_sd(next, covariance_of(input.presses, next, wider));
    if (part >= inner_part) continue;
    *options = wider;
    // Further in the length has no effect and stays at its prior.
    constexpr double kShownMm = 1e-4;
    *remark = quality.lifted_sd_mm > kShownMm
                  ? en::say(
                        "the inner {:.0f} % of each contact's radius was used; the skin leaves the "
                        "ball over {:.2f} mm",
                        100.0 * zone, next.lift_mm)
                  : inner_sentence(zone);
    return next;
  }
  return fit;
}

/// Held-out errors with the thickness in direction `along`. All directions use one zone of the
/// contacts, or their rims would decide.
std::vector<double> held_out_along(const ChoiceInput& input, CurveFamily family, MappingAlong along,
                                   const Job& job) {
  constexpr double kZone = 0.75;
  JointOptions options;
  options.along = along;
  options.zone = kZone;
  options.settled_mm = kSettledMm;
  options.shapes = input.shapes;
  options.max_rounds = input.max_rounds;
  const double x_max = domain_of(input, along);
  if (!(x_max > 0.0)) return {};
  const JointFit start =
      fit_jointly(input.presses, straight_start(input, along, x_max), options, job);
  const JointFit fit = fit_jointly(input.presses, as_family(start, family), options, job);
  if (!fit.converged || !increases(fit.curve, along)) return {};
  return hold_out(input, fit, options, job);
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
  return !is_no_worse(a_finite, b_finite, kPart);
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

/// Chooses the direction of the thickness by the held-out errors of `family`. The default is the
/// normal, as in a layer that scatters light; another direction needs evidence beyond chance.
/// Otherwise one shallow press on a steep face would decide, and all other depths would change with
/// the incline. `remark` reports another direction than the normal, or one that is equally good.
/// The two displace positions on the face by layer_mm tan(incline). For two presses and more.
MappingAlong choose_along(const ChoiceInput& input, CurveFamily family, Message* remark,
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
        "brightness follows the layer's thickness {}: error on presses left out {:.4f} mm, against "
        "{:.4f} mm along its normal",
        direction, finite_mean_mm(best), finite_mean_mm(by_normal));
  if (chosen == MappingAlong::kNormal && !by_normal.empty() && !rival.empty())
    *remark = en::say(
        "the presses do not show whether brightness follows the layer's thickness along its normal "
        "({:.4f} mm on presses left out) or along z ({:.4f} mm): the normal is assumed; if wrong, "
        "positions on the face are {:.1f} mm off along it; use larger images, and presses where "
        "the face is steep and where it is flat",
        finite_mean_mm(by_normal), finite_mean_mm(rival), separation_mm(input));
  return chosen;
}

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
double beyond_family_mm(const ChoiceInput& input, const JointFit& fit, const JointOptions& options,
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

struct FamilyCandidate {
  JointFit fit;
  std::vector<double> errors_mm;  ///< on presses left out
  double spread_mm = 0;           ///< of those fits
};

/// Fits the families, the simplest first, and returns those with an increasing curve and their
/// held-out errors (none with one press). It ends where more coefficients no longer help. One press
/// takes the first family that fits.
std::vector<FamilyCandidate> try_families(const ChoiceInput& input,
                                          const std::vector<CurveFamily>& families,
                                          const JointFit& start, const JointOptions& options,
                                          const Job& job) {
  constexpr int kMaxWorse = 3;
  std::vector<FamilyCandidate> candidates;
  double best_mm = std::numeric_limits<double>::infinity();
  int worse = 0;
  for (std::size_t i = 0; i < families.size() && worse < kMaxWorse; ++i) {
    if (job.stop_requested() && !candidates.empty()) break;
    job.report(static_cast<double>(i) / static_cast<double>(families.size()),
               en::say("trying a {}", families[i].name()));
    FamilyCandidate candidate{
        fit_jointly(input.presses, as_family(start, families[i]), options, job), {}};
    if (!candidate.fit.converged || !increases(candidate.fit.curve, options.along)) continue;
    if (input.presses.size() < 2) return {std::move(candidate)};
    candidate.errors_mm = hold_out(input, candidate.fit, options, job, &candidate.spread_mm);
    // Stopped during cross-validation; a single family needs no comparison.
    if (candidate.errors_mm.size() < input.presses.size() && families.size() > 1) break;
    const double error_mm = mean_mm(candidate.errors_mm);
    worse = error_mm < best_mm ? 0 : worse + 1;
    best_mm = std::min(best_mm, error_mm);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

/// Why `chosen` was taken, where `best` has the smallest held-out error.
Message why(const FamilyCandidate& chosen, const FamilyCandidate& best) {
  const Message name = chosen.fit.curve.family().name();
  const double error_mm = mean_mm(chosen.errors_mm);
  if (&chosen == &best)
    return en::at(name, en::say("smallest error on presses left out, {:.4f} mm", error_mm));
  return en::at(
      name,
      en::say(
          "{:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and "
          "simpler",
          error_mm, best.fit.curve.family().name(), mean_mm(best.errors_mm)));
}

/// The best of some families for one direction of the thickness.
std::optional<ModelChoice> choose_family(const ChoiceInput& input,
                                         const std::vector<CurveFamily>& families,
                                         MappingAlong along, const Job& job) {
  JointFit straight = straight_start(input, along, domain_of(input, along));
  ModelChoice choice{{along}, std::move(straight), {}, 0, {}, {}};
  if (!(choice.fit.curve.x_max() > 0.0)) return std::nullopt;
  choice.options.zone = kInnerZone;
  choice.options.settled_mm = kSettledMm;
  choice.options.shapes = input.shapes;
  choice.options.max_rounds = input.max_rounds;
  JointFit start = fit_jointly(input.presses, choice.fit, choice.options, job);
  Message zone_remark;
  start = choose_zone(input, std::move(start), &choice.options, &zone_remark, job);
  choice.remarks.push_back(std::move(zone_remark));

  const auto candidates = try_families(input, families, start, choice.options, job);
  if (candidates.empty()) return std::nullopt;
  const auto best = std::min_element(
      candidates.begin(), candidates.end(),
      [](const auto& a, const auto& b) { return mean_mm(a.errors_mm) < mean_mm(b.errors_mm); });
  const auto chosen = std::find_if(candidates.begin(), best, [&](const FamilyCandidate& one) {
    return is_no_worse(one.errors_mm, best->errors_mm, kTiePart, kFamilyErrors);
  });
  choice.fit = chosen->fit;
  choice.held_out_mm = chosen->errors_mm;
  choice.spread_mm = chosen->spread_mm;
  const Message name = choice.fit.curve.family().name();
  choice.sentence = input.presses.size() < 2
                        ? en::at(name, en::say("a single press cannot be left out"))
                    : families.size() == 1 ? en::at(name, en::say("as requested"))
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
  FamilyCandidate varying{
      fit_jointly(input.presses, as_family(choice->fit, family), choice->options, job), {}};
  if (!varying.fit.converged || !increases(varying.fit.curve, choice->options.along)) return;
  varying.errors_mm = hold_out(input, varying.fit, choice->options, job, &varying.spread_mm);
  const std::vector<double>& errors = varying.errors_mm;
  if (errors.size() < choice->held_out_mm.size() || is_no_worse(choice->held_out_mm, errors))
    return;
  const Eigen::Vector2d part = varying.fit.curve.values().tail<2>();
  choice->remarks.push_back(en::say(
      "the mapping varies over the face, as with uneven light or layer: by {:+.0f} % from the "
      "presses nearest the base to those nearest the tip, by {:+.0f} % from side to side; error on "
      "presses left out {:.4f} mm, against {:.4f} mm with one mapping for all",
      200.0 * part.x(), 200.0 * part.y(), mean_mm(errors), mean_mm(choice->held_out_mm)));
  choice->sentence = why(varying, varying);
  choice->fit = varying.fit;
  choice->held_out_mm = varying.errors_mm;
  choice->spread_mm = varying.spread_mm;
}

}  // namespace

std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                        const CalibrationSettings& settings, const Job& job) {
  auto choice = choose_along_and_family(input, settings, job);
  if (choice && settings.face_variation == FaceVariationChoice::kAuto)
    try_variation(input, &*choice, job);
  if (choice && input.presses.size() > 1 && !job.stop_requested())
    choice->spread_mm =
        std::hypot(choice->spread_mm, beyond_family_mm(input, choice->fit, choice->options, job));
  return choice;
}

double error_of_press(const PressSamples& press, const JointFit& mapping,
                      const Eigen::Vector3d& centre_mm, const JointOptions& options,
                      const Job& job) {
  // The inner zone only: the rim does not show the mapping's shape.
  JointOptions ball_only = options;
  ball_only.fix_mapping = true;
  ball_only.zone = kInnerZone;
  ball_only.watch = {};
  const std::vector<const PressSamples*> one{&press};
  const JointFit ball =
      fit_jointly(one, {mapping.curve, {centre_mm}, false, mapping.lift_mm}, ball_only, job);
  return ball.converged ? quality_of(one, ball, ball_only).residual_mm.front()
                        : std::numeric_limits<double>::infinity();
}

}  // namespace alltact
