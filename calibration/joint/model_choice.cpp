#include "calibration/joint/model_choice.h"

#include "calibration/joint/verdict.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kDomainPlaces = 12;         // of the curve, where curves are compared
constexpr double kQuietRingMm = 0.002;    // mean residual of a ring that is never held against it
constexpr double kRingExcess = 1.5;       // times the scatter of a ring's sectors
constexpr double kCertainPart = 0.01;     // of the depth: what chance leaves open is little enough
constexpr double kShortOfContact = 0.03;  // of the rim's radius: no skin is quite that membrane
constexpr double kInclineDeg = 3.0;       // needed to tell thickness along z from along the normal
constexpr int kMostCoefficients = 6;
constexpr std::size_t kVaryingPresses = 5;  // two numbers more want two presses more
// Held-out errors closer than this are the same: the balls, which take up ten times as much of a
// wrong scale as they leave to be seen, must not be led by noise.
constexpr double kTieMm = 0.001;

constexpr double kTiePart = 0.1;     // or than this part of the better one
constexpr double kSettledMm = 1e-5;  // enough to choose by

constexpr CurveFamily kMoebiusFamily{MappingKind::kMoebius, 2};
constexpr CurveFamily kLayerFamily{MappingKind::kMoebius, 3};

/// Nearly the largest of some differences: a few may be wrong.
double largest_of(std::vector<double> x) {
  if (x.empty()) return 0.0;
  const auto at =
      x.begin() + static_cast<std::ptrdiff_t>(0.995 * (static_cast<double>(x.size()) - 1));
  std::nth_element(x.begin(), at, x.end());
  return *at;
}

/// The largest difference at which the contacts' inner parts and the punches' levels are seen: the
/// end of the domain.
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
      if (disc.place_of(sample).radius < kSureZone) x.push_back(sample.x);
    x_max = std::max(x_max, largest_of(std::move(x)));
  }
  return std::min(x_max, 1.0);
}

/// A straight line through the balls as found.
JointFit straight_start(const ChoiceInput& input, MappingAlong along, double x_max) {
  JointFit fit{MappingCurve({MappingKind::kPolynomial, 1}, x_max), input.centres_mm};
  double xd = 0, xx = 0;
  for (std::size_t i = 0; i < input.presses.size(); ++i) {
    const ContactDisc disc(*input.presses[i], along, input.centres_mm[i]);
    for (const Sample& sample : input.presses[i]->samples) {
      if (disc.place_of(sample).radius > kSureZone) continue;
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

/// The same straight line, or the nearest curve of another family, to go on from.
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

std::string inner_sentence(double zone) {
  return fmt::format(
      "the inner {:.0f} % of each contact's radius was used, where the skin surely touches the "
      "ball",
      100.0 * zone);
}

/// Fits as much of each contact as ball and lift-off explain, from the rim inwards; leaves in
/// `options` which part that is. The inner part alone leaves an offset between balls and mapping
/// open, which a curve that is not quite the layer's then fills; near the rim the offset is seen.
/// The rim itself tells how far the skin follows the ball, but not in which form it comes back.
/// Where rings show that the skin does there what lift_off.h does not know, its error would be
/// taken up by the scale, ten times larger.
JointFit choose_zone(const ChoiceInput& input,
                     JointFit fit,
                     JointOptions* options,
                     std::string* remark,
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
                  ? fmt::format(
                        "the inner {:.0f} % of each contact's radius was used; the skin comes back "
                        "from the ball over {:.2f} mm",
                        100.0 * zone,
                        next.lift_mm)
                  : inner_sentence(zone);
    return next;
  }
  return fit;
}

/// What leaving presses out, one after the other, shows.
struct HeldOut {
  std::vector<double> errors_mm;  ///< in the inner part of the press left out, mean absolute
  std::vector<MappingCurve> curves;
};

/// Errors are infinite where the others did not come to an increasing curve: a family that leaving
/// one press out sends astray is not to be trusted with all of them either.
HeldOut hold_out(const ChoiceInput& input,
                 const JointFit& all,
                 const JointOptions& options,
                 const Job& job) {
  HeldOut result;
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

/// Mean absolute error of depth over the domain that the jackknife gives for a curve.
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

double mean_of(const std::vector<double>& values) {
  double mean = 0;
  for (const double v : values) mean += v / static_cast<double>(values.size());
  return mean;
}

/// How much worse a is than b on the same presses, and the standard error of that.
struct Excess {
  double mean, standard_error;
};

Excess excess_of(const std::vector<double>& a, const std::vector<double>& b) {
  const auto n = static_cast<double>(a.size());
  double mean = 0;
  for (std::size_t i = 0; i < a.size(); ++i) mean += (a[i] - b[i]) / n;
  double variance = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    variance += (a[i] - b[i] - mean) * (a[i] - b[i] - mean) / (n - 1.0);
  return {mean, std::sqrt(variance / n)};
}

/// True when a family's errors are not worth leaving it for a less simple one.
bool as_good(const std::vector<double>& a, const std::vector<double>& b) {
  const Excess excess = excess_of(a, b);
  return excess.mean <= std::max({kTieMm, kTiePart * mean_of(b), excess.standard_error});
}

std::vector<CurveFamily> families_for(const CalibrationSettings& settings, std::size_t presses) {
  const bool alone = presses < 2;
  std::vector<CurveFamily> families;
  const auto polynomial = [&](int n) { families.push_back({MappingKind::kPolynomial, n}); };
  if (settings.family == FamilyChoice::kMoebius) return {kMoebiusFamily};
  if (settings.family == FamilyChoice::kLayer) return {kLayerFamily};
  if (settings.degree > 0) {
    // A degree was asked for: that polynomial.
    polynomial(settings.degree);
    return families;
  }
  if (settings.family == FamilyChoice::kPolynomial) {
    if (alone) return {{MappingKind::kPolynomial, 2}, {MappingKind::kPolynomial, 1}};
    for (int n = 1; n <= kMostCoefficients; ++n) polynomial(n);
    return families;
  }
  // One press does not tell absorption.
  if (alone) return {kMoebiusFamily, {MappingKind::kPolynomial, 1}};
  // What a layer of scattering stuff does comes first. A straight line and the Moebius curve are
  // among its curves; as families of their own they would win ties and let the ball centres take up
  // their error in scale.
  families.push_back(kLayerFamily);
  for (int n = 2; n <= kMostCoefficients; ++n) polynomial(n);
  return families;
}

/// The steepest place of any press: on a face at right angles to z both ways are the same.
double steepest_deg(const ChoiceInput& input) {
  double low = 1.0;
  for (const PressSamples* press : input.presses)
    for (const Sample& sample : press->samples) low = std::min(low, sample.cos_incline);
  return 180.0 / M_PI * std::acos(std::clamp(low, 0.0, 1.0));
}

/// How far a curve lies from the one with a number more, fitted to the same presses, mean absolute
/// over the domain: what the chosen family cannot follow, all presses show alike and the balls take
/// up, so that leaving presses out does not show it.
double beyond_family_mm(const ChoiceInput& input,
                        const JointFit& fit,
                        const JointOptions& options,
                        const Job& job) {
  CurveFamily richer = fit.curve.family();
  if (richer.absorbs()) return 0;  // its third number is uncertain in the covariance
  richer.kind = MappingKind::kPolynomial;
  if (++richer.coefficients > kMostCoefficients) return 0;
  const JointFit other = fit_jointly(input.presses, as_family(fit, richer), options, job);
  if (!other.converged || !increases(other.curve, options.along)) return 0;
  double apart = 0;
  for (int i = 1; i <= kDomainPlaces; ++i) {
    const double x = fit.curve.x_max() * i / kDomainPlaces;
    apart += std::abs(other.curve.depth_mm(x) - fit.curve.depth_mm(x)) / kDomainPlaces;
  }
  return apart;
}

void keep(const HeldOut& held_out, ModelChoice* choice) {
  choice->held_out_mm = held_out.errors_mm;
  choice->spread_mm = spread_of(held_out.curves);
}

struct Candidate {
  JointFit fit;
  HeldOut held_out;
};

/// Fits of the families that gave an increasing curve, the simplest first, each with what leaving
/// presses out shows (nothing with one press), up to where more coefficients no longer help. One
/// press takes the first that fits.
std::vector<Candidate> try_families(const ChoiceInput& input,
                                    const std::vector<CurveFamily>& families,
                                    const JointFit& start,
                                    const JointOptions& options,
                                    const Job& job) {
  constexpr int kMostWorse = 3;
  std::vector<Candidate> candidates;
  double best_mm = std::numeric_limits<double>::infinity();
  int worse = 0;
  for (std::size_t i = 0; i < families.size() && worse < kMostWorse; ++i) {
    if (job.stop_requested() && !candidates.empty()) break;
    job.report(static_cast<double>(i) / static_cast<double>(families.size()),
               fmt::format("trying a {}", families[i].name()));
    Candidate candidate{fit_jointly(input.presses, as_family(start, families[i]), options, job),
                        {}};
    if (!candidate.fit.converged || !increases(candidate.fit.curve, options.along)) continue;
    if (input.presses.size() < 2) return {std::move(candidate)};
    candidate.held_out = hold_out(input, candidate.fit, options, job);
    // Stopped amid leaving presses out; the only family there is needs no comparing.
    if (candidate.held_out.errors_mm.size() < input.presses.size() && families.size() > 1) break;
    const double error_mm = mean_of(candidate.held_out.errors_mm);
    worse = error_mm < best_mm ? 0 : worse + 1;
    best_mm = std::min(best_mm, error_mm);
    candidates.push_back(std::move(candidate));
  }
  return candidates;
}

/// Why one of several was taken, of which one does best on presses left out.
std::string why(const Candidate& chosen, const Candidate& best) {
  const std::string name = chosen.fit.curve.family().name();
  const double error_mm = mean_of(chosen.held_out.errors_mm);
  if (&chosen == &best)
    return fmt::format("{}: least error on presses left out, {:.4f} mm", name, error_mm);
  return fmt::format(
      "{}: {:.4f} mm on presses left out, not distinguishable from the best ({}, {:.4f} mm) and "
      "simpler",
      name,
      error_mm,
      best.fit.curve.family().name(),
      mean_of(best.held_out.errors_mm));
}

/// The best of some families for one way of measuring thickness.
std::optional<ModelChoice> choose_family(const ChoiceInput& input,
                                         const std::vector<CurveFamily>& families,
                                         MappingAlong along,
                                         const Job& job) {
  ModelChoice choice{{along}, straight_start(input, along, domain_of(input, along)), {}, 0, {}, {}};
  if (!(choice.fit.curve.x_max() > 0.0)) return std::nullopt;
  choice.options.zone = kSureZone;
  choice.options.settled_mm = kSettledMm;
  choice.options.steps = input.steps;
  JointFit start = fit_jointly(input.presses, choice.fit, choice.options, job);
  std::string zone_remark;
  start = choose_zone(input, std::move(start), &choice.options, &zone_remark, job);
  choice.remarks.push_back(std::move(zone_remark));

  const auto candidates = try_families(input, families, start, choice.options, job);
  if (candidates.empty()) return std::nullopt;
  const auto best =
      std::min_element(candidates.begin(), candidates.end(), [](const auto& a, const auto& b) {
        return mean_of(a.held_out.errors_mm) < mean_of(b.held_out.errors_mm);
      });
  const auto chosen = std::find_if(candidates.begin(), best, [&](const Candidate& one) {
    return as_good(one.held_out.errors_mm, best->held_out.errors_mm);
  });
  choice.fit = chosen->fit;
  keep(chosen->held_out, &choice);
  const std::string name = choice.fit.curve.family().name();
  choice.sentence = input.presses.size() < 2
                        ? fmt::format("{}: with one press nothing can be held out", name)
                    : families.size() == 1 ? fmt::format("{}: as asked for", name)
                                           : why(*chosen, *best);
  return choice;
}

}  // namespace

MappingParameters mapping_parameters(const MappingCurve& curve,
                                     MappingAlong along,
                                     const PressedPart& part) {
  MappingParameters parameters;
  const MappingCurve stored = stored_form(curve).curve;
  parameters.kind = stored.family().kind;
  parameters.along = along;
  parameters.x_max = stored.x_max();
  if (stored.family().kind == MappingKind::kMoebius) {
    parameters.a_mm = stored.values()[0];
    parameters.b = stored.values()[1];
  } else {
    const auto numbers = stored.values().head(stored.family().coefficients);
    parameters.chebyshev.assign(numbers.begin(), numbers.end());
  }
  if (stored.family().varies)
    parameters.variation = {stored.values().tail<2>(), part.middle_mm, part.half_mm};
  return parameters;
}

bool increases(const MappingCurve& curve, MappingAlong along) {
  return Mapping::create(mapping_parameters(curve, along)).ok();
}

namespace {

/// The family by which ways of measuring thickness are compared.
CurveFamily comparing_family(const CalibrationSettings& settings,
                             const std::vector<CurveFamily>& families) {
  constexpr std::size_t kEnough = 2;  // of polynomials: of degree 3
  if (settings.family == FamilyChoice::kAuto && settings.degree == 0) return kLayerFamily;
  return families[std::min(kEnough, families.size() - 1)];
}

/// How well presses left out are told if thickness counts `along`; all ways over the same part of
/// the contacts, or what the rim makes of one would decide.
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
  const double x_max = domain_of(input, along);
  if (!(x_max > 0.0)) return {};
  const JointFit start =
      fit_jointly(input.presses, straight_start(input, along, x_max), options, job);
  const JointFit fit = fit_jointly(input.presses, as_family(start, family), options, job);
  if (!fit.converged || !increases(fit.curve, along)) return {};
  return hold_out(input, fit, options, job).errors_mm;
}

double finite_mean_of(std::vector<double> errors) {
  std::erase_if(errors, [](double e) { return !std::isfinite(e); });
  return mean_of(errors);
}

/// Whether errors a are larger than b, and not by chance, on the presses of which both tell. How
/// much larger depends on a press's incline, so that the scatter between presses is no measure of
/// chance alone.
bool is_surely_worse(const std::vector<double>& a, const std::vector<double>& b) {
  constexpr double kPart = 0.25;  // of the better one
  std::vector<double> a_told, b_told;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::isfinite(a[i]) && std::isfinite(b[i])) a_told.push_back(a[i]), b_told.push_back(b[i]);
  if (a_told.size() < 2) return false;
  const Excess excess = excess_of(a_told, b_told);
  return excess.mean > std::max({kTieMm, kPart * mean_of(b_told), excess.standard_error});
}

/// Along which thickness counts, and a remark where that is not the normal. That is what a layer
/// that scatters light does, so it is left only for what chance does not explain: one shallow press
/// on a steep place would else decide, and the depth of all others change with the incline.
MappingAlong choose_along(const ChoiceInput& input,
                          CurveFamily family,
                          std::string* remark,
                          const Job& job) {
  const auto by_normal = held_out_along(input, family, MappingAlong::kNormal, job);
  MappingAlong chosen = MappingAlong::kNormal;
  std::vector<double> best = by_normal;
  for (const MappingAlong along : {MappingAlong::kZ, MappingAlong::kProjected}) {
    const auto other = held_out_along(input, family, along, job);
    if (job.stop_requested() || other.size() < input.presses.size()) continue;
    if (!best.empty() && !is_surely_worse(best, other)) continue;
    chosen = along;
    best = other;
  }
  if (chosen != MappingAlong::kNormal && !by_normal.empty())
    *remark = fmt::format(
        "brightness follows the layer's thickness {}: {:.4f} mm on presses left out, against "
        "{:.4f} mm along its normal",
        chosen == MappingAlong::kZ ? "along z" : "along z projected onto its normal",
        finite_mean_of(best),
        finite_mean_of(by_normal));
  return chosen;
}

/// The way of measuring thickness, and the best family for it.
std::optional<ModelChoice> choose_along_and_family(const ChoiceInput& input,
                                                   const CalibrationSettings& settings,
                                                   const Job& job) {
  const auto families = families_for(settings, input.presses.size());
  if (settings.along == AlongChoice::kZ)
    return choose_family(input, families, MappingAlong::kZ, job);
  if (settings.along == AlongChoice::kProjected)
    return choose_family(input, families, MappingAlong::kProjected, job);
  const bool told_apart = input.presses.size() > 1 && steepest_deg(input) > kInclineDeg;
  if (settings.along == AlongChoice::kNormal || !told_apart)
    return choose_family(input, families, MappingAlong::kNormal, job);
  std::string remark;
  const MappingAlong along =
      choose_along(input, comparing_family(settings, families), &remark, job);
  auto choice = choose_family(input, families, along, job);
  if (choice && !remark.empty()) choice->remarks.push_back(std::move(remark));
  return choice;
}

/// Lets the mapping vary over the face where the presses ask for it.
void let_vary(const ChoiceInput& input, ModelChoice* choice, const Job& job) {
  if (input.presses.size() < kVaryingPresses || choice->held_out_mm.size() < kVaryingPresses)
    return;
  CurveFamily family = choice->fit.curve.family();
  family.varies = true;
  job.report(1.0, fmt::format("trying a {}", family.name()));
  Candidate varying{
      fit_jointly(input.presses, as_family(choice->fit, family), choice->options, job), {}};
  if (!varying.fit.converged || !increases(varying.fit.curve, choice->options.along)) return;
  varying.held_out = hold_out(input, varying.fit, choice->options, job);
  const std::vector<double>& errors = varying.held_out.errors_mm;
  if (errors.size() < choice->held_out_mm.size() || as_good(choice->held_out_mm, errors)) return;
  const Eigen::Vector2d part = varying.fit.curve.values().tail<2>();
  choice->remarks.push_back(fmt::format(
      "the mapping varies over the face, as uneven light or an uneven layer make it: by {:+.0f} % "
      "from the presses nearest to the base to those nearest to the tip, by {:+.0f} % from side to "
      "side; {:.4f} mm on presses left out, against {:.4f} mm with one mapping for all",
      200.0 * part.x(),
      200.0 * part.y(),
      mean_of(errors),
      mean_of(choice->held_out_mm)));
  choice->sentence = why(varying, varying);
  keep(varying.held_out, choice);
  choice->fit = varying.fit;
}

}  // namespace

std::optional<ModelChoice> choose_model(const ChoiceInput& input,
                                        const CalibrationSettings& settings,
                                        const Job& job) {
  auto choice = choose_along_and_family(input, settings, job);
  if (choice && settings.over_face == OverFaceChoice::kAuto) let_vary(input, &*choice, job);
  if (choice && input.presses.size() > 1 && !job.stop_requested())
    choice->spread_mm =
        std::hypot(choice->spread_mm, beyond_family_mm(input, choice->fit, choice->options, job));
  return choice;
}

}  // namespace alltact
