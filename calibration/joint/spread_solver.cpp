#include "calibration/joint/spread_solver.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kLinearFrom = 3.0;  // standard deviations from which the loss is linear

double soft_loss(double z) {
  const double q = z * z / (kLinearFrom * kLinearFrom);
  return kLinearFrom * kLinearFrom * 2.0 * (std::sqrt(1.0 + q) - 1.0);
}

double robust_weight(double z) {
  return 1.0 / std::sqrt(1.0 + z * z / (kLinearFrom * kLinearFrom));
}

}  // namespace

double Normal::scale() const {
  constexpr double kLeast = 0.05;
  double sum = 0, count = 0;
  for (const double square : mean_square)
    if (square > 0) sum += square, ++count;
  return count > 0 ? std::max(sum / count, kLeast) : 1.0;
}

SpreadSolver::SpreadSolver(const SpreadModel& model, Hypothesis hypothesis, int skip,
                           bool fix_shared)
    : model_(model),
      hypothesis_(hypothesis),
      skip_(skip),
      shared_(fix_shared ? 0 : SpreadModel::count_of(hypothesis)) {}

double SpreadSolver::cost(const FitState& state) const { return sum_up(state, false).cost; }

Normal SpreadSolver::evaluate(const FitState& state) const { return sum_up(state, true); }

Normal SpreadSolver::sum_up(const FitState& state, bool with_derivatives) const {
  const std::size_t presses = model_.presses().size();
  Normal normal;
  normal.hessian = Eigen::MatrixXd::Zero(own_at(presses), own_at(presses));
  normal.prior_hessian = normal.hessian;
  normal.gradient = Eigen::VectorXd::Zero(own_at(presses));
  for (std::size_t p = 0; p < presses; ++p) {
    if (static_cast<int>(p) == skip_) {
      normal.mean_square.push_back(0.0);
      normal.hessian.diagonal().segment<kOwnCount>(own_at(p)).setOnes();
      continue;
    }
    add_press(state, p, with_derivatives, &normal);
    add_light_prior(state, p, &normal);
    if (model_.presses()[p].given_depth) add_given_depth(state, p, &normal);
  }
  add_scales(state.shared, &normal);
  add_priors(state.shared, &normal);
  return normal;
}

void SpreadSolver::add_press(const FitState& state, std::size_t p, bool with_derivatives,
                             Normal* normal) const {
  constexpr double kStep = 1e-4;
  const SpreadPress& press = model_.presses()[p];
  const auto count = static_cast<Eigen::Index>(press.samples.size());
  const double each = std::min(1.0, press.observations / static_cast<double>(count));
  Eigen::VectorXd x, moved, residual(count), weight(count);
  model_.predict(p, hypothesis_, state.shared, state.own[p], &x);
  double sum = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const SpreadSample& sample = press.samples[static_cast<std::size_t>(k)];
    residual[k] = (x[k] - sample.x) / sample.sd;
    sum += soft_loss(residual[k]);
    weight[k] = each * robust_weight(residual[k]);
  }
  normal->cost += each * sum;
  normal->mean_square.push_back(sum / static_cast<double>(count));
  if (!with_derivatives) return;

  Eigen::MatrixXd rows(count, shared_ + kOwnCount);
  for (int c = 0; c < shared_ + kOwnCount; ++c) {
    Eigen::VectorXd shared = state.shared;
    OwnUnknowns own = state.own[p];
    (c < shared_ ? shared[c] : own[c - shared_]) += kStep;
    model_.predict(p, hypothesis_, shared, own, &moved);
    for (Eigen::Index k = 0; k < count; ++k)
      rows(k, c) = (moved[k] - x[k]) / (kStep * press.samples[static_cast<std::size_t>(k)].sd);
  }
  const Eigen::MatrixXd weighted = weight.asDiagonal() * rows;
  const Eigen::MatrixXd block = rows.transpose() * weighted;
  const Eigen::VectorXd pull = weighted.transpose() * residual;
  const Eigen::Index own = own_at(p), s = shared_;
  normal->hessian.topLeftCorner(s, s) += block.topLeftCorner(s, s);
  normal->hessian.block(0, own, s, kOwnCount) += block.topRightCorner(s, kOwnCount);
  normal->hessian.block(own, 0, kOwnCount, s) += block.bottomLeftCorner(kOwnCount, s);
  normal->hessian.block<kOwnCount, kOwnCount>(own, own) +=
      block.bottomRightCorner<kOwnCount, kOwnCount>();
  normal->gradient.head(s) += pull.head(s);
  normal->gradient.segment<kOwnCount>(own) += pull.tail<kOwnCount>();
}

void SpreadSolver::add_given_depth(const FitState& state, std::size_t p, Normal* normal) const {
  const GivenDepth& given = *model_.presses()[p].given_depth;
  const double depth = std::exp(state.own[p][kLogDepth]);
  const double z = (depth - given.mm) / given.sd_mm, row = depth / given.sd_mm;
  const Eigen::Index i = own_at(p) + kLogDepth;
  normal->cost += soft_loss(z);
  normal->hessian(i, i) += robust_weight(z) * row * row;
  normal->gradient[i] += robust_weight(z) * row * z;
}

void SpreadSolver::add_scales(const Eigen::VectorXd& shared, Normal* normal) const {
  if (shared_ == 0) return;
  for (const ScaleEvidence& seen : model_.scales()) {
    const Eigen::VectorXd row = seen.by_shared.head(shared_) / seen.sd;
    const double z = (seen.scale - 1) / seen.sd + row.dot((shared - seen.shared).head(shared_));
    normal->cost += soft_loss(z);
    normal->hessian.topLeftCorner(shared_, shared_) += robust_weight(z) * row * row.transpose();
    normal->gradient.head(shared_) += robust_weight(z) * z * row;
  }
}

void SpreadSolver::add_light_prior(const FitState& state, std::size_t p, Normal* normal) const {
  const double z = state.own[p][kLight];
  const Eigen::Index i = own_at(p) + kLight;
  normal->cost += z * z;
  normal->prior_cost += z * z;
  normal->hessian(i, i) += 1.0;
  normal->prior_hessian(i, i) += 1.0;
  normal->gradient[i] += z;
}

void SpreadSolver::add_priors(const Eigen::VectorXd& shared, Normal* normal) const {
  Eigen::MatrixXd hessian = Eigen::MatrixXd::Zero(shared_, shared_);
  const auto add = [&](double z, const Eigen::VectorXd& by) {
    normal->prior_cost += z * z;
    normal->gradient.head(shared_) += z * by;
    hessian += by * by.transpose();
  };
  const bool is_spread = hypothesis_.seen == SeenAt::kSpread && shared_ > 0;
  for (int i = 0; i < shared_; ++i) {
    if (is_spread && (i == kLogRho || i == kLogB)) continue;
    const UnknownPrior prior = prior_of(i, hypothesis_);
    add((shared[i] - prior.mean) / prior.sd, Eigen::VectorXd::Unit(shared_, i) / prior.sd);
  }
  if (is_spread) {
    const double optical_thickness = std::exp(shared[kLogOpticalThickness]);
    const auto add_curve = [&](int unknown, const CurvePrior& prior) {
      const double z = (shared[unknown] - prior.mean) / prior.sd;
      Eigen::VectorXd by = Eigen::VectorXd::Unit(shared_, unknown) / prior.sd;
      by[kLogOpticalThickness] = -(prior.mean_by_log + z * prior.sd_by_log) / prior.sd;
      add(z, by);
    };
    add_curve(kLogRho, rho_prior(optical_thickness));
    add_curve(kLogB, b_prior(optical_thickness));
  }
  normal->cost += normal->prior_cost;
  normal->hessian.topLeftCorner(shared_, shared_) += hessian;
  normal->prior_hessian.topLeftCorner(shared_, shared_) += hessian;
}

FitState SpreadSolver::moved(const FitState& state, const Eigen::VectorXd& by) const {
  constexpr double kLongest = 0.7;  // the exponentials are steep
  FitState next = state;
  const double longest = by.cwiseAbs().maxCoeff();
  const double limited = longest > kLongest ? kLongest / longest : 1.0;
  next.shared.head(shared_) += limited * by.head(shared_);
  for (std::size_t p = 0; p < next.own.size(); ++p)
    next.own[p] += limited * by.segment<kOwnCount>(own_at(p));
  return next;
}

std::optional<FitState> SpreadSolver::solve(FitState state, int max_steps, const Job& job) const {
  double damping = 1e-2;
  Normal here = evaluate(state);
  if (!std::isfinite(here.cost)) return std::nullopt;
  for (int step = 0; step < max_steps && !job.stop_requested(); ++step) {
    Eigen::MatrixXd damped = here.hessian;
    damped.diagonal() *= 1.0 + damping;
    damped.diagonal().array() += 1e-12;
    const Eigen::VectorXd by = damped.ldlt().solve(-here.gradient);
    FitState next = by.allFinite() ? moved(state, by) : state;
    const double there = by.allFinite() ? cost(next) : std::numeric_limits<double>::infinity();
    if (there < here.cost) {
      const double gained = here.cost - there;
      state = std::move(next);
      here = evaluate(state);
      damping = std::max(1e-9, damping / 5.0);
      if (gained < 1e-4 * (1.0 + 1e-3 * here.cost)) break;
    } else {
      damping *= 6.0;
      if (damping > 1e8) break;
    }
  }
  return state;
}

}  // namespace alltact
