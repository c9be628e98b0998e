#include "calibration/hard_cases/groups.h"
#include "core/geometry/ball.h"
#include "core/geometry/circle_fit.h"

#include <random>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kFocal = 1000.0;  // px

/// Directions along part of a ball's outline, noisy in the image.
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

/// The source paper's method: a circle in the image, z from its radius, x and y from its middle.
HardAnswer circle_ball(const std::vector<Eigen::Vector3d>& directions, double radius) {
  std::vector<Eigen::Vector2d> points;
  for (const auto& d : directions) points.emplace_back(kFocal * d.head<2>() / d.z());
  const auto circle = fit_circle(points);
  if (!circle) return refused("no circle");
  const double z = kFocal * radius / circle->radius;
  const Eigen::Vector2d middle = z / kFocal * circle->centre;
  return {{middle.x(), middle.y(), z}, ""};
}

/// Gauss-Newton on the distance of the centre from each ray, minus the radius, in millimetres.
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

HardAnswer ball_of(const std::vector<Eigen::Vector3d>& directions, double radius) {
  const auto found = fit_ball_to_outline(directions, radius);
  if (!found) return refused("no ball");
  return {{found->x(), found->y(), found->z()}, ""};
}

HardRow exact_outline() {
  HardRow row{"ball from its outline, up to 42 degrees off the axis, arcs from 40 degrees",
              "a circle in the picture",
              "relative",
              1e-12};
  std::mt19937 random(4);
  for (int theta = 0; theta <= 42; theta += 6)
    for (const double arc : {40.0, 90.0, 180.0, 360.0}) {
      const double t = theta * M_PI / 180.0;
      const Eigen::Vector3d c(40.0 * std::sin(t), 0.0, 40.0 * std::cos(t));
      const auto directions = outline(c, 3.0, arc, 0.0, random);
      row.ask({{c.x(), c.y(), c.z()}, {}, c.norm()},
              circle_ball(directions, 3.0),
              ball_of(directions, 3.0));
    }
  return row;
}

/// From 90 degrees of outline, 0.5 px noise. An efficient estimate at 40 mm reaches a bias below
/// 0.05 mm and a standard deviation of 0.25 mm to 15 %.
std::vector<HardRow> noisy_outlines() {
  HardRow bias{"ball's distance from 90 degrees of outline, 0.5 px noise: bias",
               "distance to the rays in mm",
               "mm",
               0.05,
               HardMeasure::kBias};
  HardRow spread{"the same: spread, against the 0.25 mm there must be",
                 "a circle through its ends and its middle",
                 "relative",
                 0.15,
                 HardMeasure::kSpread};
  HardRow aside{"the same, 30 degrees off the axis: bias",
                "a circle in the picture",
                "mm",
                0.05,
                HardMeasure::kBias};
  std::mt19937 random(5);
  const Eigen::Vector3d c(0.0, 0.0, 40.0);
  const Eigen::Vector3d off_axis(20.0, 0.0, 34.641016151377545);
  const auto distance = [](const HardAnswer& ball) {
    return ball.values.empty() ? ball : number(ball.values[2]);
  };
  for (int i = 0; i < 800; ++i) {
    const auto directions = outline(c, 3.0, 90.0, 0.5, random);
    const HardAnswer own = distance(ball_of(directions, 3.0));
    bias.ask(expected(c.z(), 1), number(millimetre_z(directions, 3.0, c)), own);
    const std::vector<Eigen::Vector3d> three{
        directions.front(), directions[directions.size() / 2], directions.back()};
    spread.ask(expected(c.z(), 0.25), distance(circle_ball(three, 3.0)), own);
    const auto seen_aside = outline(off_axis, 3.0, 90.0, 0.5, random);
    aside.ask(expected(off_axis.z(), 1),
              distance(circle_ball(seen_aside, 3.0)),
              distance(ball_of(seen_aside, 3.0)));
  }
  return {bias, spread, aside};
}

/// Kasa: linear least squares of x^2 + y^2 = 2 a x + 2 b y + c, of raw points.
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

HardAnswer radius_of(const std::optional<Circle>& circle) {
  return circle ? number(circle->radius) : refused("no circle");
}

HardRow short_arc() {
  HardRow row{"circle from 60 degrees of arc, 0.5 px noise: bias of its radius",
              "linear fit (Kasa)",
              "of its sd",
              0.1,
              HardMeasure::kBiasInSd};
  std::mt19937 random(6);
  for (int i = 0; i < 4000; ++i) {
    const auto points = arc({0.0, 0.0}, 75.0, 60.0, 0.5, random);
    row.ask(expected(75.0), number(kasa_radius(points)), radius_of(fit_circle_taubin(points)));
  }
  return row;
}

HardRow far_circle() {
  HardRow row{"exact circle far from the origin, 40 degrees of arc",
              "linear fit (Kasa)",
              "relative",
              1e-10};
  std::mt19937 random(7);
  const auto points = arc({20000.0, 10000.0}, 75.0, 40.0, 0.0, random);
  row.ask(expected(75.0), number(kasa_radius(points)), radius_of(fit_circle(points)));
  return row;
}

/// Points on lines in all directions, and as many on arcs so flat that they look like one.
HardRow straight_line() {
  HardRow row{
      "points on a line: circles invented; on an arc of 3 degrees: circles missed, or wrong "
      "by 1e-6",
      "linear fit (Kasa)",
      "part wrong",
      0,
      HardMeasure::kWrong};
  constexpr double kArc = 3.0 * M_PI / 180.0, kRadius = 500.0;
  for (int step = 0; step < 12; ++step) {
    const double turn = M_PI * step / 12;
    const Eigen::Vector2d along(std::cos(turn), std::sin(turn));
    std::vector<Eigen::Vector2d> line, arc;
    for (int i = 0; i < 40; ++i) {
      line.emplace_back(Eigen::Vector2d(100.0, 50.0) + 0.7 * i * along);
      const double angle = turn + kArc * i / 39;
      arc.emplace_back(Eigen::Vector2d(100.0, 50.0) +
                       kRadius * Eigen::Vector2d(std::cos(angle), std::sin(angle)));
    }
    for (const auto fit : {fit_circle, fit_circle_taubin}) {
      row.ask(expected_refusal({"no circle"}), number(kasa_radius(line)), radius_of(fit(line)));
      row.ask(expected(kRadius, 1e-6 * kRadius), number(kasa_radius(arc)), radius_of(fit(arc)));
    }
  }
  return row;
}

}  // namespace

std::vector<HardRow> hard_outlines() {
  std::vector<HardRow> all{exact_outline()};
  for (HardRow& row : noisy_outlines()) all.push_back(std::move(row));
  for (const HardRow& row : {short_arc(), far_circle(), straight_line()}) all.push_back(row);
  return all;
}

}  // namespace alltact
