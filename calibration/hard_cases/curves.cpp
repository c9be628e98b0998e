#include "calibration/hard_cases/exact.h"
#include "calibration/hard_cases/groups.h"
#include "calibration/joint_fit.h"
#include "core/finger/mapping.h"
#include "core/numerics/chebyshev.h"
#include "core/numerics/least_squares.h"
#include "core/simulation/hertz.h"

#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

Eigen::MatrixXd chebyshev_design(const Eigen::VectorXd& x, double middle, double half, int n) {
  Eigen::MatrixXd design(x.size(), n);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    design.row(i) = chebyshev_row((x[i] - middle) / half, n);
  return design;
}

Eigen::MatrixXd power_design(const Eigen::VectorXd& x, int n) {
  Eigen::MatrixXd design(x.size(), n);
  for (Eigen::Index i = 0; i < x.size(); ++i)
    for (int k = 0; k < n; ++k) design(i, k) = std::pow(x[i], k);
  return design;
}

Eigen::VectorXd normal_equations(const Eigen::MatrixXd& design, const Eigen::VectorXd& y) {
  return (design.transpose() * design).ldlt().solve(design.transpose() * y);
}

/// NIST's Wampler problems: 1 + x + .. + x^5 at 0..20, and what is exactly at right angles to it.
HardCase wampler(int size, double bound, const char* what) {
  HardCase one{what, "normal equations in powers", "relative", 0, 0, bound};
  constexpr double kDelta[] = {759,   -2048, 2048,  -2048, 2523,  -2048, 2048,
                               -2048, 1838,  -2048, 2048,  -2048, 1838,  -2048,
                               2048,  -2048, 2523,  -2048, 2048,  -2048, 759};
  Eigen::VectorXd x(21), y(21);
  for (int i = 0; i <= 20; ++i) {
    x[i] = i;
    y[i] = 0;
    for (int k = 5; k >= 0; --k) y[i] = y[i] * i + 1;
    y[i] += size * kDelta[i];
  }
  const std::vector<double> powers =
      exact::powers(least_squares(chebyshev_design(x, 10, 10, 6), y), 10, 10);
  const Eigen::VectorXd plain = normal_equations(power_design(x, 6), y);
  for (std::size_t k = 0; k < 6; ++k) {
    keep_worst(relative_error(powers[k], 1), one.our_error);
    keep_worst(std::abs(plain[static_cast<Eigen::Index>(k)] - 1), one.plain_error);
  }
  return one;
}

/// Degree 10 over a range far from zero, as in NIST's Filip.
HardCase high_degree() {
  HardCase one{"values of a fitted polynomial of degree 10 over -9 .. -3",
               "normal equations in powers",
               "relative",
               0,
               0,
               1e-13};
  constexpr int kTerms = 11;
  std::mt19937 random(13);
  std::normal_distribution<double> noise(0.0, 0.003);
  Eigen::VectorXd x(82), y(82);
  for (int i = 0; i < 82; ++i) {
    x[i] = -9.0 + 6.0 * i / 81.0;
    y[i] = 0.85 + 0.08 * std::sin(1.7 * x[i]) + noise(random);
  }
  const std::vector<double> truth = exact::fitted_values(x, y, kTerms);
  const Eigen::VectorXd plain = normal_equations(power_design(x, kTerms), y);
  const Eigen::VectorXd ours = least_squares(chebyshev_design(x, -6, 3, kTerms), y);
  for (Eigen::Index i = 0; i < 82; ++i) {
    const double value = truth[static_cast<std::size_t>(i)];
    keep_worst(relative_error(chebyshev_value(ours, (x[i] + 6) / 3), value), one.our_error);
    keep_worst(relative_error(exact::polynomial(plain, x[i]), value), one.plain_error);
  }
  return one;
}

/// A calibrated curve read where nobody calibrated it.
HardCase beyond_the_domain() {
  HardCase one{"mapping at x from -1 to 2: depths below 0, falling, or beyond four times the last",
               "the polynomial goes on",
               "of 3001",
               0,
               0,
               0};
  MappingParameters p;
  p.x_max = 0.6;
  p.chebyshev = {1.9, 0.35, -0.16};
  const auto mapping = Mapping::create(p);
  if (!mapping) return one.our_error = std::numeric_limits<double>::infinity(), one;
  const double limit = 4 * mapping->depth_mm(p.x_max) * (1 + 1e-12);
  const std::vector<double> powers = mapping->powers();
  double before = -1, plain_before = -std::numeric_limits<double>::infinity();
  for (int i = 0; i <= 3000; ++i) {
    const double x = -1.0 + 0.001 * i;
    const double depth = mapping->depth_mm(x);
    if (!(depth >= 0 && depth <= limit && depth >= before)) ++one.our_error;
    before = depth;
    double plain = 0;
    for (std::size_t k = powers.size(); k-- > 0;) plain = plain * x + powers[k];
    if (!(plain >= 0 && plain <= limit && plain >= plain_before)) ++one.plain_error;
    plain_before = plain;
  }
  return one;
}

/// One press, a cubic mapping, 1 grey level of noise at a brightness of 120: how well the ball's
/// distance is known, with the mapping through zero and without.
HardCase gauge() {
  HardCase one{"ball's distance from one press: its standard deviation",
               "a constant is fitted too",
               "mm",
               0,
               0,
               0.02};
  const double radius = 3.0, depth_mm = 1.0;
  MappingCurve curve({MappingKind::kPolynomial, 3}, 0.6);
  curve.values() << 2.4, 0.5, 0.05;
  const Eigen::Vector3d centre(0, 0, 40.0 + radius - depth_mm);
  // J' J of (constant, mapping, centre) over the samples in the contact.
  constexpr Eigen::Index kMap = 3, kAll = 1 + kMap + 3;
  Eigen::MatrixXd rows(0, kAll);
  for (int v = -40; v <= 40; ++v)
    for (int u = -40; u <= 40; ++u) {
      Sample sample;
      sample.untouched_z = sample.untouched_n = {0.06 * u, 0.06 * v, 40.0};
      sample.normal = Eigen::Vector3d::UnitZ();
      Eigen::Vector3d by_centre;
      const double depth = ball_depth_mm(sample, MappingAlong::kZ, centre, radius, &by_centre);
      if (!(depth > 0.03)) continue;
      double low = 0, high = 0.6;  // the x that reads as this depth
      for (int i = 0; i < 60; ++i)
        (curve.depth_mm(0.5 * (low + high)) < depth ? low : high) = 0.5 * (low + high);
      Eigen::Vector3d by_values;
      [[maybe_unused]] const double read = curve.depth_mm(low, by_values.data());
      const double sd = curve.slope_mm(low) / 120.0 * std::hypot(1.0, 1.0 - low);
      rows.conservativeResize(rows.rows() + 1, kAll);
      rows.bottomRows<1>() << 1.0, by_values.transpose(), -by_centre.transpose();
      rows.bottomRows<1>() /= sd;
    }
  const auto sd_of_distance = [](const Eigen::MatrixXd& design) {
    const Eigen::Index n = design.cols();
    const Eigen::MatrixXd r = Eigen::HouseholderQR<Eigen::MatrixXd>(design)
                                  .matrixQR()
                                  .topRows(n)
                                  .triangularView<Eigen::Upper>();
    const Eigen::VectorXd last =
        r.transpose().triangularView<Eigen::Lower>().solve(Eigen::VectorXd::Unit(n, n - 1));
    return last.norm();
  };
  one.our_error = sd_of_distance(rows.rightCols(kAll - 1));
  one.plain_error = sd_of_distance(rows);
  return one;
}

HardCase hertz() {
  HardCase one{"skin beside a ball (Hertz), out to a million radii of contact",
               "the closed form",
               "relative",
               0,
               0,
               1e-9};
  for (int i = 0; i <= 240; ++i) {
    const double q = std::pow(10.0, -6.0 * i / 240.0);
    const double truth = exact::hertz_tail(q);
    keep_worst(relative_error(hertz_tail(q), truth), one.our_error);
    const double p = 1 / q;
    const double plain = ((2 - p * p) * std::asin(q) + std::sqrt(std::max(0.0, p * p - 1))) / M_PI;
    keep_worst(relative_error(plain, truth), one.plain_error);
  }
  return one;
}

/// Steep series at the ends of the range, in powers and by Clenshaw's recurrence.
HardCase steep_series() {
  HardCase one{"value of a series of 20 terms", "powers of t", "of its greatest term", 0, 0, 1e-14};
  std::mt19937 random(14);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::VectorXd c(20);
  for (double& value : c) value = uniform(random);
  const std::vector<double> powers = exact::powers(c, 0.0, 1.0);
  for (int i = 0; i <= 100; ++i) {
    const double t = -1.0 + 0.02 * i;
    const double value = exact::series(c, t);
    double plain = 0;
    for (std::size_t k = powers.size(); k-- > 0;) plain = plain * t + powers[k];
    keep_worst(std::abs(chebyshev_value(c, t) - value) / c.lpNorm<Eigen::Infinity>(),
               one.our_error);
    keep_worst(std::abs(plain - value) / c.lpNorm<Eigen::Infinity>(), one.plain_error);
  }
  return one;
}

}  // namespace

std::vector<HardCase> hard_curves() {
  return {high_degree(),
          wampler(100, 1e-8, "coefficients of NIST's Wampler4"),
          wampler(10000, 1e-7, "coefficients of NIST's Wampler5"),
          steep_series(),
          beyond_the_domain(),
          gauge(),
          hertz()};
}

}  // namespace alltact
