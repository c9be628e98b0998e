#include "calibration/joint/joint_fit.h"

#include "calibration/joint/ceres_solver.h"
#include "calibration/joint/joint_costs.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <Eigen/Dense>
#include <ceres/ceres.h>

namespace alltact {
namespace {

// Weights change after every round, so that one round needs no full precision.
constexpr int kStepsARound = 20;
constexpr double kLeftARound = 1e-8;       // of the sum of squares
constexpr std::size_t kFewestForBall = 5;  // samples: a centre has three numbers
constexpr std::size_t kFewestForAll = 6;

/// Solves one weighted least-squares problem. False when nothing could be evaluated.
bool solve(const std::vector<WeightedPress>& weighted, const JointOptions& options, const Job& job,
           JointFit* fit) {
  const MappingCurve family = fit->curve;
  const bool lifts_off = fit->lift_mm > 0.0, free_lift = lift_is_free(*fit, options);
  double log_lift = lifts_off ? std::log(fit->lift_mm) : 0.0;
  ceres::Problem problem;
  for (std::size_t i = 0; i < weighted.size(); ++i) {
    if (weighted[i].samples.size() < (options.fix_mapping ? kFewestForBall : kFewestForAll))
      return false;
    // CompressedCost: hundreds of samples a press, but only five to a dozen unknowns.
    problem.AddResidualBlock(
        new CompressedCost(std::make_unique<PressCost>(weighted[i], family, options, lifts_off)),
        nullptr, fit->centres_mm[i].data(), fit->curve.values().data(), &log_lift);
    if (!weighted[i].outline.empty())
      problem.AddResidualBlock(new OutlineCost(weighted[i]), nullptr, fit->centres_mm[i].data());
    if (weighted[i].given_depth)
      problem.AddResidualBlock(new GivenDepthCost(weighted[i]), nullptr, fit->centres_mm[i].data());
  }
  if (options.shapes != nullptr && !options.fix_mapping)
    for (const KnownShape& shape : *options.shapes)
      problem.AddResidualBlock(new ScaleCost(shape, family, options.along), nullptr,
                               fit->curve.values().data());
  if (options.fix_mapping)
    problem.SetParameterBlockConstant(fit->curve.values().data());
  else if (family.family().absorbs())
    problem.AddResidualBlock(
        new PriorCost(family.family().numbers(), 2, kAbsorptionMean, kAbsorptionSd), nullptr,
        fit->curve.values().data());
  if (free_lift)
    problem.AddResidualBlock(new PriorCost(1, 0, std::log(kTypicalLiftMm), 1.0), nullptr,
                             &log_lift);
  else
    problem.SetParameterBlockConstant(&log_lift);
  ceres::Solver::Options solver = solver_settings();
  solver.max_num_iterations = kStepsARound;
  solver.function_tolerance = kLeftARound;
  StopWithJob stop(job, ceres::SOLVER_TERMINATE_SUCCESSFULLY);
  solver.callbacks.push_back(&stop);
  ceres::Solver::Summary summary;
  ceres::Solve(solver, &problem, &summary);
  if (free_lift) fit->lift_mm = std::exp(log_lift);
  return summary.IsSolutionUsable();
}

double change_between(const JointFit& a, const JointFit& b) {
  double change = (a.curve.values() - b.curve.values()).cwiseAbs().maxCoeff();
  change = std::max(change, std::abs(a.lift_mm - b.lift_mm));
  for (std::size_t i = 0; i < a.centres_mm.size(); ++i)
    change = std::max(change, (a.centres_mm[i] - b.centres_mm[i]).cwiseAbs().maxCoeff());
  return change;
}

bool is_finite(const JointFit& fit) {
  if (!fit.curve.values().allFinite() || !std::isfinite(fit.lift_mm)) return false;
  return std::all_of(fit.centres_mm.begin(), fit.centres_mm.end(),
                     [](const Eigen::Vector3d& c) { return c.allFinite(); });
}

}  // namespace

JointFit fit_jointly(const std::vector<const PressSamples*>& presses, JointFit start,
                     const JointOptions& options, const Job& job) {
  JointFit fit = std::move(start);
  fit.converged = false;
  for (int round = 0; round < options.max_rounds && !job.stop_requested(); ++round) {
    std::vector<WeightedPress> weighted;
    weighted.reserve(presses.size());
    for (std::size_t i = 0; i < presses.size(); ++i)
      weighted.push_back(weight_samples(*presses[i], fit, fit.centres_mm[i], options));
    JointFit next = fit;
    if (!solve(weighted, options, job, &next) || !is_finite(next)) return fit;
    const double change = change_between(next, fit);
    fit = std::move(next);
    fit.converged = true;
    if (options.watch) options.watch(round + 1, change, fit);
    if (change < options.settled_mm) break;
  }
  return fit;
}

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
  if (input.shapes != nullptr)
    for (const KnownShape& shape : *input.shapes) {
      std::vector<double> x;
      for (const Sample& sample : samples_of(shape).samples) x.push_back(sample.x);
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
  const CurveFamily from = fit.curve.family();
  if (from == family) return fit;
  MappingCurve curve(family, fit.curve.x_max());
  const bool varies_only = from.kind == family.kind && from.coefficients == family.coefficients &&
                           from.numbers() <= family.numbers();
  if (varies_only || (from == kMoebiusFamily && family == kLayerFamily))
    curve.values().head(from.numbers()) = fit.curve.values();
  else
    curve.set_line(fit.curve.depth_mm(fit.curve.x_max()) / fit.curve.x_max());
  return {curve, fit.centres_mm, false, fit.lift_mm};
}

}  // namespace alltact
