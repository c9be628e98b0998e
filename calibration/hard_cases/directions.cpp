#include "calibration/hard_cases/exact.h"
#include "calibration/hard_cases/groups.h"
#include "core/geometry/ball.h"
#include "core/sensing/face/face_shape.h"

#include <random>

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
  return hit ? number(hit->near) : refused("misses the ball");
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
    row.ask(expected(exact::near_root(ray.direction, c, r)),
            number(naive_near(ray, c, r)),
            near_of(ray, c, r));
  }
  return row;
}

/// Rays that pass a few roundings inside or outside the rim. They must hit as in 50 digits, to a
/// nanometre, and miss as in 50 digits.
HardRow rim_decision() {
  HardRow row{"whether and where a ray meets a ball, 1e-13 mm from its rim",
              "b^2 - 4 a c",
              "part wrong",
              0,
              HardMeasure::kWrong};
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
                        : expected_refusal({"misses"}),
            std::isfinite(naive) ? number(naive) : refused("misses the ball"),
            near_of(ray, c, kRadius));
  }
  return row;
}

/// Thickness of the layer along its normal on a face seen nearly from the side. The textbook
/// thickens it along z by 1 / cos(atan(slope)); along the normal the thickness must be the same.
HardRow steep_layer() {
  HardRow row{"thickness of the layer at slopes up to 1e17",
              "t / cos(atan(slope)), along z",
              "relative",
              4 * kEps};
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
    row.ask(
        expected(kLayer), number(kLayer / std::cos(angle) / length), number(exact::norm(lifted)));
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

}  // namespace alltact
