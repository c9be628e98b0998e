// Ground truth from arithmetic in 50 decimal digits, rounded to the nearest double at the end.
#pragma once

#include <vector>

#include <Eigen/Core>

namespace alltact::exact {

struct Angle {
  double sine, angle;
};
/// Between two directions.
[[nodiscard]] Angle between(const Eigen::Vector3d& p, const Eigen::Vector3d& c);

/// First intersection of the line through the origin along `u` with a ball, as a multiple of u.
[[nodiscard]] double near_root(const Eigen::Vector3d& u, const Eigen::Vector3d& c, double radius);

/// Distance of c from the line through the origin along u, minus `radius`.
[[nodiscard]] double outside(const Eigen::Vector3d& u, const Eigen::Vector3d& c, double radius);

[[nodiscard]] double norm(const Eigen::Vector3d& v);

/// Coefficients in ascending powers of x of sum_k c_k T_k((x - middle) / half).
[[nodiscard]] std::vector<double> powers(const Eigen::VectorXd& c, double middle, double half);

/// sum_k c_k T_k(t).
[[nodiscard]] double series(const Eigen::VectorXd& c, double t);

/// sum_k c_k x^k.
[[nodiscard]] double polynomial(const Eigen::VectorXd& c, double x);

/// Values at x of the polynomial of n terms that is closest to y, by least squares.
[[nodiscard]] std::vector<double> fitted_values(const Eigen::VectorXd& x, const Eigen::VectorXd& y,
                                                int n);

/// Hertz's surface outside a ball's contact (ball_contact.h).
[[nodiscard]] double hertz_tail(double q);

}  // namespace alltact::exact
