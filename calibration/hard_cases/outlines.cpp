#include "calibration/hard_cases/groups.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"

#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kFocal = 1000.0;  // px

/// Mean and standard deviation of what many draws gave.
struct Spread {
  double mean = 0, sd = 0;
  explicit Spread(const std::vector<double>& values) {
    for (const double v : values) mean += v / static_cast<double>(values.size());
    for (const double v : values)
      sd += (v - mean) * (v - mean) / static_cast<double>(values.size() - 1);
    sd = std::sqrt(sd);
  }
};

/// Directions along part of a ball's outline, noisy in the picture.
std::vector<Eigen::Vector3d> outline(const Eigen::Vector3d& centre,
                                     double radius,
                                     double arc_deg,
                                     double noise_px,
                                     std::mt19937& random) {
  const int all = 540;
  const auto horizon = ball_horizon_mm(true, centre, radius, all);
  const auto used = static_cast<std::size_t>(all * arc_deg / 360.0);
  std::normal_distribution<double> noise(0.0, noise_px / kFocal);
  std::vector<Eigen::Vector3d> directions;
  for (std::size_t i = 0; i < used; ++i) {
    const Eigen::Vector3d& p = horizon[i];
    if (noise_px > 0.0)
      directions.emplace_back(p.x() / p.z() + noise(random), p.y() / p.z() + noise(random), 1.0);
    else
      directions.push_back(p);
  }
  return directions;
}

/// The source paper's way: a circle in the picture, and z from its radius.
double circle_z_mm(const std::vector<Eigen::Vector3d>& directions, double radius) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& d : directions) points.emplace_back(kFocal * d.head<2>() / d.z());
  const auto circle = fit_circle(points);
  return circle ? kFocal * radius / circle->radius : NAN;
}

/// Gauss-Newton on the distance of the centre from each ray, less the radius, in millimetres.
double millimetre_z(const std::vector<Eigen::Vector3d>& directions,
                    double radius,
                    Eigen::Vector3d c) {
  for (int round = 0; round < 30; ++round) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d pull = Eigen::Vector3d::Zero();
    for (const auto& d : directions) {
      const Eigen::Vector3d u = d.normalized();
      const Eigen::Vector3d aside = c - u.dot(c) * u;
      const Eigen::Vector3d by = aside.normalized();
      normal += by * by.transpose();
      pull += by * (aside.norm() - radius);
    }
    c -= normal.ldlt().solve(pull);
  }
  return c.z();
}

HardCase exact_outline() {
  HardCase one{"ball from its outline, up to 42 degrees off the axis, arcs from 40 degrees",
               "a circle in the picture",
               "relative",
               0,
               0,
               1e-12};
  std::mt19937 random(4);
  for (int theta = 0; theta <= 42; theta += 6)
    for (const double arc : {40.0, 90.0, 180.0, 360.0}) {
      const double t = theta * M_PI / 180.0;
      const Eigen::Vector3d c(40.0 * std::sin(t), 0.0, 40.0 * std::cos(t));
      const auto directions = outline(c, 3.0, arc, 0.0, random);
      const auto found = fit_ball_to_outline(directions, 3.0);
      keep_worst(found ? (*found - c).norm() / c.norm() : NAN, one.our_error);
      keep_worst(std::abs(circle_z_mm(directions, 3.0) - c.z()) / c.z(), one.plain_error);
    }
  return one;
}

std::vector<HardCase> noisy_outlines() {
  HardCase bias{"ball's distance from 90 degrees of outline, 0.5 px noise: bias",
                "distance to the rays in mm",
                "mm",
                0,
                0,
                0.05};
  HardCase spread{"the same: spread against the 0.25 mm there must be",
                  "a circle in the picture",
                  "mm",
                  0,
                  0,
                  0.15 * 0.25};
  std::mt19937 random(5);
  const Eigen::Vector3d c(0.0, 0.0, 40.0);
  const Eigen::Vector3d off_axis(20.0, 0.0, 34.641016151377545);
  std::vector<double> ours, plain, by_circle;
  for (int i = 0; i < 800; ++i) {
    const auto directions = outline(c, 3.0, 90.0, 0.5, random);
    ours.push_back(fit_ball_to_outline(directions, 3.0).value_or(Eigen::Vector3d::Zero()).z());
    plain.push_back(millimetre_z(directions, 3.0, c));
    by_circle.push_back(circle_z_mm(outline(off_axis, 3.0, 90.0, 0.5, random), 3.0));
  }
  bias.our_error = std::abs(Spread(ours).mean - 40.0);
  bias.plain_error = std::abs(Spread(plain).mean - 40.0);
  spread.our_error = std::abs(Spread(ours).sd - 0.25);
  spread.plain_error = std::abs(Spread(by_circle).mean - off_axis.z());
  return {bias, spread};
}

/// Kasa: linear least squares of x^2 + y^2 = 2 a x + 2 b y + c, of points as they are.
double kasa_radius(const std::vector<Eigen::Vector2d>& points) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (const auto& p : points) {
    const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
    normal += row * row.transpose();
    pull += row * p.squaredNorm();
  }
  const Eigen::Vector3d found = normal.ldlt().solve(pull);
  return std::sqrt(found[2] + found.head<2>().squaredNorm());
}

std::vector<Eigen::Vector2d> arc(const Eigen::Vector2d& centre,
                                 double radius,
                                 double arc_deg,
                                 double noise,
                                 std::mt19937& random) {
  std::normal_distribution<double> normal;
  std::vector<Eigen::Vector2d> points;
  const int count = static_cast<int>(1.5 * arc_deg);
  for (int i = 0; i < count; ++i) {
    const double angle = arc_deg * M_PI / 180.0 * i / (count - 1);
    const Eigen::Vector2d aside(noise > 0 ? noise * normal(random) : 0.0,
                                noise > 0 ? noise * normal(random) : 0.0);
    points.emplace_back(centre + radius * Eigen::Vector2d(std::cos(angle), std::sin(angle)) +
                        aside);
  }
  return points;
}

HardCase short_arc() {
  HardCase one{"circle from 60 degrees of arc, 0.5 px noise: bias of its radius",
               "linear fit (Kasa)",
               "of its sd",
               0,
               0,
               0.1};
  std::mt19937 random(6);
  std::vector<double> taubin, plain;
  for (int i = 0; i < 4000; ++i) {
    const auto points = arc({0.0, 0.0}, 75.0, 60.0, 0.5, random);
    taubin.push_back(fit_circle_taubin(points).value_or(Circle{}).radius);
    plain.push_back(kasa_radius(points));
  }
  one.our_error = std::abs(Spread(taubin).mean - 75.0) / Spread(taubin).sd;
  one.plain_error = std::abs(Spread(plain).mean - 75.0) / Spread(plain).sd;
  return one;
}

HardCase far_circle() {
  HardCase one{"exact circle far from the origin, 40 degrees of arc",
               "linear fit (Kasa)",
               "relative",
               0,
               0,
               1e-10};
  std::mt19937 random(7);
  const auto points = arc({20000.0, 10000.0}, 75.0, 40.0, 0.0, random);
  const auto circle = fit_circle(points);
  keep_worst(circle ? std::abs(circle->radius - 75.0) / 75.0 : NAN, one.our_error);
  keep_worst(std::abs(kasa_radius(points) - 75.0) / 75.0, one.plain_error);
  return one;
}

HardCase straight_line() {
  HardCase one{"points on a line: circles invented", "linear fit (Kasa)", "circles", 0, 0, 0};
  std::vector<Eigen::Vector2d> points;
  for (int i = 0; i < 40; ++i) points.emplace_back(100.0 + 0.3 * i, 50.0 + 0.7 * i);
  one.our_error = (fit_circle(points) ? 1 : 0) + (fit_circle_taubin(points) ? 1 : 0);
  const double radius = kasa_radius(points);
  one.plain_error = std::isfinite(radius) ? 1.0 : std::numeric_limits<double>::infinity();
  return one;
}

}  // namespace

std::vector<HardCase> hard_outlines() {
  std::vector<HardCase> all{exact_outline()};
  for (HardCase& one : noisy_outlines()) all.push_back(std::move(one));
  for (const HardCase& one : {short_arc(), far_circle(), straight_line()}) all.push_back(one);
  return all;
}

}  // namespace alltact
