// Bounded least squares for a model with rendered images.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Unknowns, each scaled so that steps of kTwinStep are small, but well above rounding.
struct TwinUnknowns {
  Eigen::VectorXd start, low, high;
};
inline constexpr double kTwinStep = 2e-3;  // of forward differences

/// Residuals and, where `jacobian` is not null, their derivatives by the unknowns. False: no image.
using TwinModel = std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& residuals,
                                     Eigen::MatrixXd* jacobian)>;

struct TwinSolution {
  Eigen::VectorXd x, residuals;
  Eigen::MatrixXd jacobian;
  std::vector<char> at_bound;  ///< one an unknown
  [[nodiscard]] double rms() const;
};

/// Stopping rule: a number of iterations, or a relative gain below this in the sum of squares.
/// Images are rendered in single precision, which limits the gain.
struct TwinEffort {
  int iterations = 60;
  double min_gain = 1e-6;
};

/// Solved by Ceres (Levenberg and Marquardt). Errors: no image at the start; a solution that is not
/// finite. A stopped job returns the best solution so far.
[[nodiscard]] Result<TwinSolution> solve_twin(const TwinModel& model, const TwinUnknowns& unknowns,
                                              Eigen::Index residuals, TwinEffort effort,
                                              const Job& job);

/// Standard deviations from a covariance with residuals that are independent between clusters and
/// arbitrarily correlated within them (Liang and Zeger 1986, times n / (n - 1)). clusters: one
/// number a residual. Empty for unknowns at a bound and those that the residuals do not separate
/// from others.
[[nodiscard]] std::vector<std::optional<double>> clustered_sd(const TwinSolution& solution,
                                                              const std::vector<int>& clusters);

}  // namespace alltact
