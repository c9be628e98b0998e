// A robust smooth curve through points with gross outliers.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// y(x) as a Chebyshev series with its covariance.
struct RobustPolynomial {
  double first = 0, last = 0;   ///< range of x over the inliers
  double middle = 0, half = 1;  ///< t = (x - middle) / half
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd covariance;
  double scale = 1;  ///< spread of the residuals in units of the points' own sd
  int inliers = 0;

  [[nodiscard]] double value(double x) const;
  /// value(x) at x = first_x + i * step for i = 0 .. n - 1.
  [[nodiscard]] std::vector<double> values(double first_x, double step, int n) const;
  /// Standard deviation of value(x).
  [[nodiscard]] double sd(double x) const;
};

/// Iteratively re-weighted least squares: Cauchy weights from a median start, then Tukey's biweight
/// (c = 4.685), on residuals divided by sd. Each round solves the normal equations for the
/// correction of the coefficients, with residuals of the points themselves, so that rounding errors
/// shrink from round to round. Points with valid = 0 do not count. nullopt: fewer than 2 (degree +
/// 1) points are valid or inliers, or they do not determine the curve.
[[nodiscard]] std::optional<RobustPolynomial> fit_robust_polynomial(const std::vector<double>& x,
                                                                    const std::vector<double>& y,
                                                                    const std::vector<double>& sd,
                                                                    const std::vector<char>& valid,
                                                                    int degree);

}  // namespace alltact
