// Chebyshev polynomials of the first kind on [-1, 1]: evaluation by Clenshaw's recurrence.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// sum_k c_k T_k(t). Backward stable for |t| <= 1; an empty series is 0.
template <class Coefficients, class T>
[[nodiscard]] T chebyshev_value(const Coefficients& c, const T& t) {
  T next(0.0), after(0.0);
  for (auto k = static_cast<Eigen::Index>(c.size()) - 1; k >= 1; --k) {
    const T value = 2.0 * t * next - after + c[k];
    after = next;
    next = value;
  }
  return c.size() == 0 ? T(0.0) : T(t * next - after + c[0]);
}

/// The series at t = first + i * step for i = 0 .. n - 1, vectorised; bitwise equal to
/// chebyshev_value.
void chebyshev_values(const Eigen::VectorXd& c, double first, double step, int n, double* values);

/// The coefficients of d/dt of a series.
[[nodiscard]] inline Eigen::VectorXd chebyshev_derivative(const Eigen::VectorXd& c) {
  const Eigen::Index n = c.size();
  if (n < 2) return Eigen::VectorXd::Zero(1);
  Eigen::VectorXd derivative = Eigen::VectorXd::Zero(n + 1);
  for (Eigen::Index k = n - 1; k >= 1; --k)
    derivative[k - 1] = derivative[k + 1] + 2.0 * static_cast<double>(k) * c[k];
  derivative[0] /= 2.0;
  return derivative.head(n - 1);
}

/// T_0(t) .. T_{n-1}(t).
[[nodiscard]] inline Eigen::RowVectorXd chebyshev_row(double t, Eigen::Index n) {
  Eigen::RowVectorXd row(n);
  for (Eigen::Index k = 0; k < n; ++k)
    row[k] = k == 0 ? 1.0 : k == 1 ? t : 2.0 * t * row[k - 1] - row[k - 2];
  return row;
}

// A robust smooth curve through points with gross outliers.

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
