// Least squares within bounds, of a model whose pictures have to be rendered.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Unknowns, each scaled so that steps of kTwinStep are small and can be told from rounding.
struct TwinUnknowns {
  Eigen::VectorXd start, low, high;
};
inline constexpr double kTwinStep = 2e-3;  // of forward differences

/// Residuals and, where `jacobian` is not null, how the unknowns move them. False: there is no
/// picture.
using TwinModel = std::function<bool(
    const Eigen::VectorXd& x, Eigen::VectorXd& residuals, Eigen::MatrixXd* jacobian)>;

struct TwinSolution {
  Eigen::VectorXd x, residuals;
  Eigen::MatrixXd jacobian;
  std::vector<char> at_bound;  ///< one an unknown
  [[nodiscard]] double rms() const;
};

/// When it is enough: so many iterations, or a relative gain below this in the sum of squares. A
/// picture is rendered in single precision, so that nothing much finer can be told.
struct TwinEffort {
  int iterations = 60;
  double least_gain = 1e-6;
};

/// By Ceres (Levenberg and Marquardt). Errors: no picture at the start, a solution that is not
/// finite. A stopped job ends it with the best so far.
[[nodiscard]] Result<TwinSolution> solve_twin(const TwinModel& model,
                                              const TwinUnknowns& unknowns,
                                              Eigen::Index residuals,
                                              TwinEffort effort,
                                              const Job& job);

/// Covariance with residuals that are independent between clusters, and anything within them (Liang
/// and Zeger 1986, times n / (n - 1)); one cluster's number a residual. Absent for unknowns at a
/// bound and those that the residuals do not tell from others.
[[nodiscard]] std::vector<std::optional<double>> clustered_sd(const TwinSolution& solution,
                                                              const std::vector<int>& clusters);

}  // namespace alltact
