#include "calibration/joint/joint_fit.h"

#include "calibration/joint/compressed_cost.h"
#include "calibration/joint/joint_costs.h"
#include "calibration/joint/solver_settings.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>
#include <ceres/ceres.h>

namespace alltact {
namespace {

// Weights change after every round, so that one round needs no full precision.
constexpr int kStepsARound = 20;
constexpr double kLeftARound = 1e-8;       // of the sum of squares
constexpr std::size_t kFewestForBall = 5;  // samples: a centre has three numbers
constexpr std::size_t kFewestForAll = 6;

class StopWithJob final : public ceres::IterationCallback {
 public:
  explicit StopWithJob(const Job& job) : job_(job) {}
  ceres::CallbackReturnType operator()(const ceres::IterationSummary&) override {
    return job_.stop_requested() ? ceres::SOLVER_TERMINATE_SUCCESSFULLY : ceres::SOLVER_CONTINUE;
  }

 private:
  const Job& job_;
};

/// Solves one weighted least-squares problem. False when nothing could be evaluated.
bool solve(const std::vector<WeightedPress>& weighted,
           const JointOptions& options,
           const Job& job,
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
        nullptr,
        fit->centres_mm[i].data(),
        fit->curve.values().data(),
        &log_lift);
    if (!weighted[i].outline.empty())
      problem.AddResidualBlock(new OutlineCost(weighted[i]), nullptr, fit->centres_mm[i].data());
    if (weighted[i].given_depth)
      problem.AddResidualBlock(new GivenDepthCost(weighted[i]), nullptr, fit->centres_mm[i].data());
  }
  if (options.steps != nullptr && !options.fix_mapping)
    for (const StepSamples& step : *options.steps)
      problem.AddResidualBlock(
          new StepCost(step, family, options.along), nullptr, fit->curve.values().data());
  if (options.fix_mapping)
    problem.SetParameterBlockConstant(fit->curve.values().data());
  else if (family.family().absorbs())
    problem.AddResidualBlock(new AbsorptionCost(family), nullptr, fit->curve.values().data());
  if (free_lift)
    problem.AddResidualBlock(new LiftCost(), nullptr, &log_lift);
  else
    problem.SetParameterBlockConstant(&log_lift);
  ceres::Solver::Options solver = solver_settings();
  solver.max_num_iterations = kStepsARound;
  solver.function_tolerance = kLeftARound;
  StopWithJob stop(job);
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
  return std::all_of(fit.centres_mm.begin(), fit.centres_mm.end(), [](const Eigen::Vector3d& c) {
    return c.allFinite();
  });
}

}  // namespace

JointFit fit_jointly(const std::vector<const PressSamples*>& presses,
                     JointFit start,
                     const JointOptions& options,
                     const Job& job) {
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
    if (options.watch != nullptr) (*options.watch)(round + 1, change, fit);
    if (change < options.settled_mm) break;
  }
  return fit;
}

}  // namespace alltact
