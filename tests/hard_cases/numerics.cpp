#include "calibration/joint/joint_fit.h"
#include "core/finger/mapping.h"
#include "core/geometry/ball.h"
#include "core/numerics/chebyshev.h"
#include "core/numerics/linear_algebra.h"
#include "core/sensing/face/face_shape.h"
#include "core/simulation/mechanics/ball_contact.h"
#include "tests/hard_cases/exact.h"
#include "tests/hard_cases/hard_cases.h"

#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kEps = 2.220446049250313e-16;

Eigen::Vector3d random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// A ball's angular radius, from its middle and a direction that grazes it.
HardRow angular_radius(double low, double high, const char* what) {
  HardRow row{what, "sqrt(1 - cos^2)", "relative", 8 * kEps};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0), length(20.0, 90.0);
  for (int i = 0; i < 300; ++i) {
    const double alpha = low * std::pow(high / low, part(random));
    const Eigen::Vector3d c = length(random) * random_unit(random);
    const Eigen::Vector3d aside = c.cross(random_unit(random)).normalized();
    const Eigen::Vector3d p = c + std::tan(alpha) * c.norm() * aside;
    const auto [sine, angle] = exact::between(p, c);
    const double cosine = p.dot(c) / (p.norm() * c.norm());
    row.ask(expected(sine), number(std::sqrt(1.0 - cosine * cosine)), number(sine_between(p, c)));
    row.ask(expected(angle), number(std::acos(cosine)), number(angle_between(p, c)));
  }
  return row;
}

HardAnswer near_of(const Ray& ray, const Eigen::Vector3d& c, double radius) {
  const auto hit = intersect_ball(ray, c, radius);
  return hit ? number(hit->near) : refused(HardRefusal::kNoHit);
}

/// The textbook's near root; NaN where it finds none.
double naive_near(const Ray& ray, const Eigen::Vector3d& c, double radius) {
  const double pa = ray.direction.squaredNorm(), pb = -2.0 * ray.direction.dot(c);
  const double pc = c.squaredNorm() - radius * radius;
  return (-pb - std::sqrt(pb * pb - 4.0 * pa * pc)) / (2.0 * pa);
}

/// Near root of rays that pass the ball's centre at R (1 - graze).
HardRow grazing_ray(double graze, double bound, const char* what) {
  HardRow row{what, "b^2 - 4 a c", "relative", bound};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> radius(0.5, 5.0);
  for (int i = 0; i < 300; ++i) {
    const double r = radius(random);
    const Eigen::Vector3d axis = random_unit(random);
    const Eigen::Vector3d aside = axis.unitOrthogonal();
    const Ray ray{Eigen::Vector3d::Zero(), axis * (1.0 + 0.5 * radius(random))};
    const Eigen::Vector3d c = 40.0 * axis + r * (1.0 - graze) * aside;
    row.ask(expected(exact::near_root(ray.direction, c, r)), number(naive_near(ray, c, r)),
            near_of(ray, c, r));
  }
  return row;
}

/// Rays that pass a few roundings inside or outside the rim. They must hit as in 50 digits, to a
/// nanometre, and miss as in 50 digits.
HardRow rim_decision() {
  HardRow row{"whether and where a ray meets a ball, 1e-13 mm from its rim", "b^2 - 4 a c",
              "part wrong", 0, HardMeasure::kWrong};
  constexpr double kRadius = 3.0, kNanometre = 1e-6;
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray{Eigen::Vector3d::Zero(), random_unit(random)};
    const Eigen::Vector3d c = 40.0 * ray.direction + kRadius * ray.direction.unitOrthogonal() *
                                                         (1.0 + (i % 2 ? 4e-14 : -4e-14));
    const double outside = exact::outside(ray.direction, c, kRadius);
    // Closer than this the centre's own rounding decides.
    if (std::abs(outside) < 4 * kEps * 43.0) continue;
    const double naive = naive_near(ray, c, kRadius);
    row.ask(outside < 0 ? expected(exact::near_root(ray.direction, c, kRadius), kNanometre)
                        : expected_refusal(HardRefusal::kNoHit),
            std::isfinite(naive) ? number(naive) : refused(HardRefusal::kNoHit),
            near_of(ray, c, kRadius));
  }
  return row;
}

/// Thickness of the layer along its normal on a face seen nearly from the side. The textbook
/// thickens it along z by 1 / cos(atan(slope)); along the normal the thickness must be the same.
HardRow steep_layer() {
  HardRow row{"thickness of the layer at slopes up to 1e17", "t / cos(atan(slope)), along z",
              "relative", 4 * kEps};
  constexpr double kLayer = 1.5;
  for (int i = 0; i < 200; ++i) {
    const double slope = std::pow(10.0, 17.0 * i / 199.0);
    const double length = std::hypot(1.0, slope);
    // In memory: otherwise the compiler replaces it by 1 / sqrt(1 + slope^2), which is not the
    // textbook's.
    const volatile double angle = std::atan(slope);
    FaceShape::Local local{};
    local.view_point_mm.setZero();
    local.normal = {-slope / length, 0.0, 1.0 / length};
    local.cos_incline = 1.0 / length;
    const Eigen::Vector3d lifted = untouched_point_mm(local, kLayer, MappingAlong::kNormal);
    row.ask(expected(kLayer), number(kLayer / std::cos(angle) / length),
            number(exact::norm(lifted)));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_directions() {
  return {angular_radius(0.05, 1.5, "radius of a ball in the picture, 0.05 to 1.5 rad"),
          angular_radius(1e-4, 1e-2, "radius of a small ball, 1e-4 to 1e-2 rad"),
          angular_radius(1e-12, 1e-7, "radius of a speck, 1e-12 to 1e-7 rad"),
          grazing_ray(1e-4, 1e-13, "where a ray meets a ball, grazing by 1e-4"),
          grazing_ray(1e-10, 1e-11, "where a ray meets a ball, grazing by 1e-10"),
          rim_decision(),
          steep_layer()};
}

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

/// NIST's Wampler problems: 1 + x + .. + x^5 at 0..20, and a component exactly orthogonal to it.
HardRow wampler(int size, double bound, const char* what) {
  HardRow row{what, "normal equations in powers", "relative", bound};
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
  const Eigen::VectorXd naive = normal_equations(power_design(x, 6), y);
  for (std::size_t k = 0; k < 6; ++k)
    row.ask(expected(1), number(naive[static_cast<Eigen::Index>(k)]), number(powers[k]));
  return row;
}

/// Degree 10 over a range far from zero, as in NIST's Filip.
HardRow high_degree() {
  HardRow row{"values of a fitted polynomial of degree 10 over -9 .. -3",
              "normal equations in powers", "relative", 1e-13};
  constexpr int kTerms = 11;
  std::mt19937 random(13);
  std::normal_distribution<double> noise(0.0, 0.003);
  Eigen::VectorXd x(82), y(82);
  for (int i = 0; i < 82; ++i) {
    x[i] = -9.0 + 6.0 * i / 81.0;
    y[i] = 0.85 + 0.08 * std::sin(1.7 * x[i]) + noise(random);
  }
  const std::vector<double> truth = exact::fitted_values(x, y, kTerms);
  const Eigen::VectorXd naive = normal_equations(power_design(x, kTerms), y);
  const Eigen::VectorXd own = least_squares(chebyshev_design(x, -6, 3, kTerms), y);
  for (Eigen::Index i = 0; i < 82; ++i)
    row.ask(expected(truth[static_cast<std::size_t>(i)]), number(exact::polynomial(naive, x[i])),
            number(chebyshev_value(own, (x[i] + 6) / 3)));
  return row;
}

/// A calibrated curve outside its calibrated range: straight lines with the slopes at its ends,
/// from a layer of twice the thickness to one of none.
HardRow beyond_the_domain() {
  HardRow row{"mapping from a layer of 1.5 mm that has doubled to one that is used up",
              "the polynomial goes on", "mm", 1e-12};
  constexpr double kEnd = 0.6, kLayer = 1.5;
  const Eigen::Vector3d coefficients(1.9, 0.35, -0.16);
  // d = x p(t) with t = 2 x / kEnd - 1, p(1) = sum c_k, p'(1) = sum k^2 c_k
  const double end_depth = kEnd * coefficients.sum();
  const double end_slope = coefficients.sum() + 2 * (coefficients[1] + 4 * coefficients[2]);
  // p(-1) = sum (-1)^k c_k
  const double start_slope = coefficients[0] - coefficients[1] + coefficients[2];
  MappingParameters p;
  p.x_max = kEnd;
  p.chebyshev = {coefficients[0], coefficients[1], coefficients[2]};
  const auto mapping = Mapping::create(p);
  for (int i = 0; i <= 3000; ++i) {
    const double x = -1.0 + 0.001 * i;
    const double polynomial = x * exact::series(coefficients, 2 * x / kEnd - 1);
    const double straight = end_depth + end_slope * (x - kEnd);
    const double truth = x <= 0 ? start_slope * x : x <= kEnd ? polynomial : straight;
    if (truth < -kLayer) continue;
    if (truth > kLayer) break;
    row.ask(expected(truth, 1), number(polynomial),
            mapping ? number(mapping->depth_mm(x)) : refused(mapping.error()));
  }
  return row;
}

/// Equations of one press for (constant, cubic mapping, the ball's centre): a row for each pixel
/// inside its contact, relative to the noise of 1 grey level at a brightness of 120.
Eigen::MatrixXd one_press() {
  const double radius = 3.0, depth_mm = 1.0;
  MappingCurve curve({MappingKind::kPolynomial, 3}, 0.6);
  curve.values() << 2.4, 0.5, 0.05;
  const Eigen::Vector3d centre(0, 0, 40.0 + radius - depth_mm);
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
  return rows;
}

/// The ball's distance from one press, with the mapping through zero and without: its sd from
/// noise, to first order. Through zero 0.004 mm is achievable.
HardRow gauge() {
  HardRow row{"ball's distance from one noisy press", "a constant is fitted too", "mm rms", 0.006,
              HardMeasure::kRms};
  const Eigen::MatrixXd press = one_press();
  std::mt19937 random(21);
  std::normal_distribution<double> noise;
  for (int trial = 0; trial < 100; ++trial) {
    Eigen::VectorXd drawn(press.rows());
    for (double& one : drawn) one = noise(random);
    const auto distance_off = [&](Eigen::Index unknowns) {
      return least_squares(press.rightCols(unknowns), drawn)[unknowns - 1];
    };
    row.ask(expected(42.0, 1), number(42.0 + distance_off(press.cols())),
            number(42.0 + distance_off(press.cols() - 1)));
  }
  return row;
}

HardRow hertz() {
  HardRow row{"skin beside a ball (Hertz), out to a million radii of contact", "the closed form",
              "relative", 1e-9};
  for (int i = 0; i <= 240; ++i) {
    const double q = std::pow(10.0, -6.0 * i / 240.0);
    const double p = 1 / q;
    const double naive = ((2 - p * p) * std::asin(q) + std::sqrt(std::max(0.0, p * p - 1))) / M_PI;
    row.ask(expected(exact::hertz_tail(q)), number(naive), number(hertz_tail(q)));
  }
  return row;
}

/// Steep series at the ends of the range, in powers and by Clenshaw's recurrence.
HardRow steep_series() {
  HardRow row{"value of a series of 20 terms", "powers of t", "of its greatest term", 1e-14};
  std::mt19937 random(14);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  Eigen::VectorXd c(20);
  for (double& value : c) value = uniform(random);
  const std::vector<double> powers = exact::powers(c, 0.0, 1.0);
  for (int i = 0; i <= 100; ++i) {
    const double t = -1.0 + 0.02 * i;
    double naive = 0;
    for (std::size_t k = powers.size(); k-- > 0;) naive = naive * t + powers[k];
    row.ask(expected(exact::series(c, t), c.lpNorm<Eigen::Infinity>()), number(naive),
            number(chebyshev_value(c, t)));
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_curves() {
  return {high_degree(),
          wampler(100, 1e-8, "coefficients of NIST's Wampler4"),
          wampler(10000, 1e-7, "coefficients of NIST's Wampler5"),
          steep_series(),
          beyond_the_domain(),
          gauge(),
          hertz()};
}

}  // namespace alltact
