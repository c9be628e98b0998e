#include "calibration/joint/light_spread_fit.h"

#include "calibration/joint/known_shape.h"
#include "calibration/joint/spread_solver.h"
#include "core/numerics/parallel.h"
#include "core/sensing/depth/light_spread.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr std::size_t kMinPresses = 3;
constexpr std::array kBeds{Bed::kMembrane, Bed::kHalfSpace};

/// A hypothesis with its best fit.
struct FittedHypothesis {
  Hypothesis hypothesis;
  FitState state;
  Normal normal;
};

/// The best of some starts, of which the most promising one is followed to its end.
std::optional<FittedHypothesis> best_fit(const SpreadModel& model, Hypothesis hypothesis,
                                         const Job& job) {
  constexpr int kTriedSteps = 10, kSteps = 60;
  const SpreadSolver solver(model, hypothesis);
  const std::vector<double> thicknesses =
      hypothesis.seen == SeenAt::kSpread ? std::vector{0.5, 1.6} : std::vector{0.5};
  std::optional<FitState> best;
  double least_cost = 0;
  for (const double optical_thickness : thicknesses) {
    FitState from = model.start();
    from.shared[kLogOpticalThickness] = std::log(optical_thickness);
    from.shared[kLogB] = b_prior(optical_thickness).mean;
    auto state = solver.solve(from, kTriedSteps, job);
    if (!state) continue;
    const double cost = solver.evaluate(*state).cost;
    if (!best || cost < least_cost) best = std::move(state), least_cost = cost;
  }
  if (best) best = solver.solve(*best, kSteps, job);
  if (!best) return std::nullopt;
  return FittedHypothesis{hypothesis, *best, solver.evaluate(*best)};
}

/// For each bed.
using FitOfBeds = std::array<std::optional<FittedHypothesis>, kBeds.size()>;

FitOfBeds best_fits(const SpreadModel& model, SeenAt seen, const Job& job) {
  FitOfBeds fits;
  parallel_for(static_cast<int>(kBeds.size()), default_threads(), [&](int first, int last) {
    for (int i = first; i < last; ++i) {
      const auto k = static_cast<std::size_t>(i);
      fits[k] = best_fit(model, {seen, kBeds[k]}, job);
    }
  });
  return fits;
}

/// nullopt: no fit, or the job was stopped.
std::optional<FittedHypothesis> best_spread(const SpreadModel& model, const Job& job) {
  std::optional<FittedHypothesis> best;
  for (auto& fitted : best_fits(model, SeenAt::kSpread, job))
    if (fitted && (!best || fitted->normal.cost < best->normal.cost)) best = std::move(fitted);
  if (job.stop_requested()) return std::nullopt;
  return best;
}

/// log of the likelihood of an observation, by the mean square of the residuals of many. Their own
/// scale counts, but at least that of the noise and of what formulas leave.
double log_likelihood(double mean_square) {
  return -0.5 * (mean_square < 1.0 ? mean_square : 1.0 + std::log(mean_square));
}

/// Of a symmetric positive definite matrix.
double log_determinant(const Eigen::MatrixXd& matrix) {
  return 2.0 * matrix.llt().matrixLLT().diagonal().array().log().sum();
}

/// log of the part of what the priors allow that the data leave (Laplace's approximation of the
/// evidence; D. MacKay, Information Theory, Inference and Learning Algorithms, 28.2).
double log_volume_left(const Normal& normal) {
  Eigen::MatrixXd prior = normal.prior_hessian;
  const auto presses = static_cast<Eigen::Index>(normal.mean_square.size());
  // Positions within a millimetre, depths within a factor of e: a ball that its press does not
  // determine is no evidence.
  for (Eigen::Index own = prior.rows() - kOwnCount * presses; own < prior.rows(); own += kOwnCount)
    for (const Own unknown : {kAlong, kAcross, kLogDepth})
      prior(own + unknown, own + unknown) += 1.0;
  const Eigen::MatrixXd data = (normal.hessian - normal.prior_hessian) / normal.scale();
  return 0.5 * (log_determinant(prior) - log_determinant(data + prior));
}

/// How much more probable spread light is than a local one.
struct Evidence {
  double log_ratio = std::numeric_limits<double>::infinity();
  double log_likelihood_ratio = 0;  ///< by the observations, of this
  double presses = 1;               ///< part of the presses that show it
};

Evidence evidence_against(const SpreadModel& model, const Normal& local, const Normal& spread) {
  const double presses = static_cast<double>(model.presses().size());
  Evidence evidence;
  evidence.presses = 0;
  for (std::size_t p = 0; p < model.presses().size(); ++p) {
    const double gained = model.presses()[p].observations * (log_likelihood(spread.mean_square[p]) -
                                                             log_likelihood(local.mean_square[p]));
    evidence.log_likelihood_ratio += gained;
    if (gained > 0) evidence.presses += 1.0 / presses;
  }
  evidence.log_ratio = evidence.log_likelihood_ratio +
                       0.5 * (local.prior_cost - spread.prior_cost) + log_volume_left(spread) -
                       log_volume_left(local);
  return evidence;
}

// 3 and 4 to 1. Less is known of local light's curve before: in noise that prior alone would decide
// for spread light.
constexpr double kLeastByObservations = 1.0, kLeastEvidence = 1.5;

/// Against the local light that explains most, or the first one that explains enough.
Evidence evidence_of(const SpreadModel& model, const FittedHypothesis& spread, const Job& job) {
  Evidence least;
  for (const SeenAt seen :
       {SeenAt::kNormal, SeenAt::kZ, SeenAt::kSight, SeenAt::kOuterZ, SeenAt::kOuterSight})
    for (const auto& local : best_fits(model, seen, job)) {
      if (!local) continue;
      const Evidence against = evidence_against(model, local->normal, spread.normal);
      if (against.log_ratio < least.log_ratio) least = against;
      if (!(least.log_ratio > kLeastEvidence)) return least;
    }
  return least;
}

bool is_seen(const Evidence& evidence) {
  constexpr double kMostPresses = 0.5;
  return std::isfinite(evidence.log_ratio) && evidence.log_ratio > kLeastEvidence &&
         evidence.log_likelihood_ratio > kLeastByObservations && evidence.presses >= kMostPresses;
}

/// The mapping of the presses' mean angle of sight; those of other angles are converted to it.
/// Without covariances.
MappingParameters mapping_of(const SpreadModel& model, const FitState& state) {
  MappingParameters mapping;
  mapping.kind = MappingKind::kMoebius;
  mapping.along = MappingAlong::kNormal;
  mapping.spread = model.spread_by(state.shared);
  double b_factor = 0;
  for (std::size_t p = 0; p < model.presses().size(); ++p) {
    const SpreadSample& nearest = model.presses()[p].nearest_to(state.own[p].head<2>());
    b_factor += oblique_spread(mapping.spread, nearest.cos_sight).b_factor /
                static_cast<double>(model.presses().size());
  }
  mapping.b = (1.0 + mapping.spread.b_straight) * b_factor - 1.0;
  mapping.a_mm = std::exp(state.shared[kLogRho]) * model.layer_mm() * (1.0 + mapping.b);
  return mapping;
}

/// With covariances, from that of the unknowns.
MappingParameters mapping_of(const SpreadModel& model, const FitState& state,
                             const Eigen::MatrixXd& covariance) {
  MappingParameters mapping = mapping_of(model, state);
  mapping.spread.optical_thickness_sd =
      mapping.spread.optical_thickness *
      std::sqrt(std::max(0.0, covariance(kLogOpticalThickness, kLogOpticalThickness)));
  Eigen::MatrixXd by_stored = Eigen::MatrixXd::Zero(2, covariance.rows());
  for (const Shared unknown : {kLogRho, kLogB, kLogOpticalThickness}) {
    constexpr double kStep = 1e-4;
    FitState moved = state;
    moved.shared[unknown] += kStep;
    const MappingParameters there = mapping_of(model, moved);
    by_stored(0, unknown) = (there.a_mm - mapping.a_mm) / kStep;
    by_stored(1, unknown) = (there.b - mapping.b) / kStep;
  }
  const Eigen::MatrixXd stored = by_stored * covariance * by_stored.transpose();
  mapping.covariance = 0.5 * (stored + stored.transpose());
  return mapping;
}

/// Of all unknowns; not finite where they are not determined.
Eigen::MatrixXd covariance_of(const Normal& normal) {
  const Eigen::Index n = normal.hessian.rows();
  return normal.scale() * normal.hessian.ldlt().solve(Eigen::MatrixXd::Identity(n, n));
}

/// The scales by all bodies at a state, with their derivatives by differences.
std::vector<ScaleEvidence> scales_at(const SpreadModel& model, const FitState& state,
                                     const ReadScales& read_scales) {
  std::vector<ScaleEvidence> scales;
  for (const ScaleSeen& seen : read_scales(mapping_of(model, state)))
    scales.push_back(
        {seen.scale, seen.sd, state.shared, Eigen::VectorXd::Zero(state.shared.size())});
  if (scales.empty()) return scales;
  for (const Shared unknown : {kLogRho, kLogB, kLogBAlong, kLogOpticalThickness, kLogWidth}) {
    constexpr double kStep = 0.01;
    FitState moved = state;
    moved.shared[unknown] += kStep;
    const std::vector<ScaleSeen> there = read_scales(mapping_of(model, moved));
    for (std::size_t i = 0; i < scales.size(); ++i)
      scales[i].by_shared[unknown] = (there[i].scale - scales[i].scale) / kStep;
  }
  return scales;
}

/// Repeats a fit with the bodies that agree with the balls. Returns the scales by the balls alone.
std::vector<ScaleByBalls> use_scales(const ReadScales& read_scales, const Job& job,
                                     SpreadModel* model, FittedHypothesis* fitted) {
  constexpr int kRounds = 3, kSteps = 25;
  const Eigen::MatrixXd covariance = covariance_of(fitted->normal);
  std::vector<ScaleByBalls> by_balls;
  for (int round = 0; round < kRounds && !job.stop_requested(); ++round) {
    std::vector<ScaleEvidence> all = scales_at(*model, fitted->state, read_scales), used;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (round == 0) {
        const Eigen::VectorXd& by = all[i].by_shared;
        const double variance = by.dot(covariance.topLeftCorner(by.size(), by.size()) * by);
        const double sd = std::sqrt(all[i].sd * all[i].sd + std::max(0.0, variance));
        by_balls.push_back(
            {all[i].scale, sd, std::abs(all[i].scale - 1) <= kContradictionSds * sd});
      }
      if (by_balls[i].agrees) used.push_back(std::move(all[i]));
    }
    if (used.empty()) break;
    model->set_scales(std::move(used));
    const SpreadSolver solver(*model, fitted->hypothesis);
    const auto state = solver.solve(fitted->state, kSteps, job);
    if (!state) break;
    fitted->state = *state;
    fitted->normal = solver.evaluate(*state);
  }
  return by_balls;
}

/// False where a ball lies off its face.
bool add_balls(const std::vector<BallStart>& balls, const SpreadModel& model, const FitState& state,
               const Eigen::MatrixXd& covariance, LightSpreadFit* fit) {
  fit->centre_covariance = Eigen::MatrixXd::Zero(3 * static_cast<Eigen::Index>(balls.size()), 3);
  for (std::size_t p = 0; p < balls.size(); ++p) {
    const FaceShape& shape = balls[p].press->shape;
    const auto pixel = pixel_of_position(shape, state.own[p].head<2>());
    const auto local = pixel ? shape.at(pixel->x(), pixel->y()) : std::nullopt;
    if (!local) return false;
    const double depth = std::exp(state.own[p][kLogDepth]);
    fit->centres_mm.push_back(untouched_point_mm(*local, model.layer_mm(), MappingAlong::kNormal) +
                              (model.presses()[p].radius_mm - depth) * local->normal);
    const Eigen::Index at = kSharedCount + kOwnCount * static_cast<Eigen::Index>(p);
    const double variance =
        depth * depth * std::max(0.0, covariance(at + kLogDepth, at + kLogDepth));
    fit->centre_covariance.block<3, 3>(3 * static_cast<Eigen::Index>(p), 0) =
        variance * local->normal * local->normal.transpose();
  }
  return true;
}

/// Change of each ball's depth where the other presses alone give what all share.
std::vector<double> held_out_mm(const SpreadModel& model, const FittedHypothesis& spread,
                                const Job& job) {
  constexpr int kAgain = 25;
  std::vector<double> changes_mm;
  for (std::size_t p = 0; p < model.presses().size() && !job.stop_requested(); ++p) {
    const double depth_mm = std::exp(spread.state.own[p][kLogDepth]);
    changes_mm.push_back(depth_mm);  // where nothing is found out
    const auto others = SpreadSolver(model, spread.hypothesis, static_cast<int>(p))
                            .solve(spread.state, kAgain, job);
    if (!others) continue;
    FitState ball = *others;
    ball.own = spread.state.own;
    const auto alone = SpreadSolver(model, spread.hypothesis, -1, true).solve(ball, kAgain, job);
    if (alone) changes_mm.back() = std::abs(std::exp(alone->own[p][kLogDepth]) - depth_mm);
  }
  return changes_mm;
}

}  // namespace

std::optional<LightSpreadFit> fit_light_spread(const std::vector<BallStart>& balls,
                                               const Face& face, const ReadScales& read_scales,
                                               const Job& job) {
  if (balls.size() < kMinPresses) return std::nullopt;
  std::vector<SpreadPress> presses;
  for (const BallStart& ball : balls) {
    auto press = spread_press(*ball.press, face, ball.centre_mm);
    if (!press) return std::nullopt;
    presses.push_back(std::move(*press));
  }
  SpreadModel model(std::move(presses), face.layer_mm);
  auto spread = best_spread(model, job);
  if (!spread) return std::nullopt;
  const Evidence evidence = evidence_of(model, *spread, job);
  if (job.stop_requested()) return std::nullopt;
  LightSpreadFit fit;
  fit.log_evidence = evidence.log_ratio;
  if (!is_seen(evidence)) return fit;
  if (!covariance_of(spread->normal).allFinite()) return fit;
  if (read_scales) fit.scales = use_scales(read_scales, job, &model, &*spread);
  const Eigen::MatrixXd covariance = covariance_of(spread->normal);
  if (!covariance.allFinite()) return fit;
  fit.mapping = mapping_of(model, spread->state, covariance);
  if (!add_balls(balls, model, spread->state, covariance, &fit)) return fit;
  if (spread->hypothesis.bed == Bed::kMembrane)
    fit.lift_mm = std::exp(spread->state.shared[kLogReturn]);
  fit.held_out_mm = held_out_mm(model, *spread, job);
  fit.is_seen = true;
  return fit;
}

Press without_light_spread(const Press& press, const MappingParameters& mapping) {
  Press local = press;
  remove_light_spread(mapping, press.shape, &local.difference);
  return local;
}

}  // namespace alltact
