// Fit of a hypothesis of spread or local light to all presses (spread_model.h).
#pragma once

#include "calibration/joint/spread_model.h"
#include "core/base/job.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Normal equations at a state, and its cost: squares of residuals over their standard deviations,
/// linear from 3 of them, and of the priors. Unknowns: Shared, then Own of each press.
struct Normal {
  Eigen::MatrixXd hessian;
  Eigen::VectorXd gradient;
  double cost = 0;
  double prior_cost = 0;            ///< contained in it
  Eigen::MatrixXd prior_hessian;    ///< contained in the hessian
  std::vector<double> mean_square;  ///< robust, of the weighted residuals, by press

  /// Mean square of the residuals of all presses that count.
  [[nodiscard]] double scale() const;
};

/// Levenberg-Marquardt.
class SpreadSolver {
 public:
  /// `skip`: a press that does not count for the shared unknowns; -1: none. `fix_shared`: only
  /// balls move. `model` must outlive it.
  SpreadSolver(const SpreadModel& model, Hypothesis hypothesis, int skip = -1,
               bool fix_shared = false);

  [[nodiscard]] double cost(const FitState& state) const;
  [[nodiscard]] Normal evaluate(const FitState& state) const;
  /// nullopt where no step leads to finite values. The best so far where the job is stopped.
  [[nodiscard]] std::optional<FitState> solve(FitState state, int max_steps, const Job& job) const;

 private:
  [[nodiscard]] Eigen::Index own_at(std::size_t press) const {
    return shared_ + kOwnCount * static_cast<Eigen::Index>(press);
  }
  [[nodiscard]] Normal sum_up(const FitState& state, bool with_derivatives) const;
  void add_press(const FitState& state, std::size_t press, bool with_derivatives,
                 Normal* normal) const;
  void add_given_depth(const FitState& state, std::size_t press, Normal* normal) const;
  void add_scales(const Eigen::VectorXd& shared, Normal* normal) const;
  void add_light_prior(const FitState& state, std::size_t press, Normal* normal) const;
  void add_priors(const Eigen::VectorXd& shared, Normal* normal) const;
  [[nodiscard]] FitState moved(const FitState& state, const Eigen::VectorXd& by) const;

  const SpreadModel& model_;
  Hypothesis hypothesis_;
  int skip_;
  int shared_;
};

}  // namespace alltact
