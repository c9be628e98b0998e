#include "calibration/hard_cases/exact.h"
#include "calibration/hard_cases/groups.h"
#include "core/geometry/ball.h"
#include "core/sensing/face_shape.h"

#include <random>

namespace alltact {
namespace {

constexpr double kEps = 2.220446049250313e-16;

Eigen::Vector3d random_unit(std::mt19937& random) {
  std::normal_distribution<double> normal;
  return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
}

/// The radius under which a ball is seen, from its middle and a direction that grazes it.
HardCase angular_radius(double least, double most, const char* what) {
  HardCase one{what, "sqrt(1 - cos^2)", "relative", 0, 0, 8 * kEps};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> part(0.0, 1.0), length(20.0, 90.0);
  for (int i = 0; i < 300; ++i) {
    const double alpha = least * std::pow(most / least, part(random));
    const Eigen::Vector3d c = length(random) * random_unit(random);
    const Eigen::Vector3d aside = c.cross(random_unit(random)).normalized();
    const Eigen::Vector3d p = c + std::tan(alpha) * c.norm() * aside;
    const auto [sine, angle] = exact::between(p, c);
    const double cosine = p.dot(c) / (p.norm() * c.norm());
    keep_worst(relative_error(std::sqrt(1.0 - cosine * cosine), sine), one.plain_error);
    keep_worst(relative_error(sine_between(p, c), sine), one.our_error);
    keep_worst(relative_error(angle_between(p, c), angle), one.our_error);
  }
  return one;
}

/// Near root of rays that pass the ball's centre at R (1 - graze).
HardCase grazing_ray(double graze, double bound, const char* what) {
  HardCase one{what, "b^2 - 4 a c", "relative", 0, 0, bound};
  std::mt19937 random(2);
  std::uniform_real_distribution<double> radius(0.5, 5.0);
  for (int i = 0; i < 300; ++i) {
    const double r = radius(random);
    const Eigen::Vector3d axis = random_unit(random);
    const Eigen::Vector3d aside = axis.unitOrthogonal();
    const Ray ray{Eigen::Vector3d::Zero(), axis * (1.0 + 0.5 * radius(random))};
    const Eigen::Vector3d c = 40.0 * axis + r * (1.0 - graze) * aside;
    const double truth = exact::near_root(ray.direction, c, r);
    const double pa = ray.direction.squaredNorm(), pb = -2.0 * ray.direction.dot(c);
    const double pc = c.squaredNorm() - r * r;
    keep_worst(relative_error((-pb - std::sqrt(pb * pb - 4.0 * pa * pc)) / (2.0 * pa), truth),
               one.plain_error);
    const auto hit = meet_ball(ray, c, r);
    keep_worst(hit ? relative_error(hit->near, truth) : NAN, one.our_error);
  }
  return one;
}

/// Rays that pass a few roundings inside or outside the rim: met or missed, as in 50 digits.
HardCase rim_decision() {
  HardCase one{
      "whether a ray meets a ball, 1e-13 mm from its rim", "b^2 - 4 a c", "part wrong", 0, 0, 0};
  std::mt19937 random(3);
  int wrong = 0, plain_wrong = 0, tried = 0;
  for (int i = 0; i < 2000; ++i) {
    const double r = 3.0;
    const Eigen::Vector3d u = random_unit(random);
    const Eigen::Vector3d c = 40.0 * u + r * u.unitOrthogonal() * (1.0 + (i % 2 ? 4e-14 : -4e-14));
    const double outside = exact::outside(u, c, r);
    // Closer than this the centre's own rounding decides.
    if (std::abs(outside) < 4 * kEps * 43.0) continue;
    ++tried;
    const bool truth = outside < 0.0;
    const double pb = u.dot(c), pc = c.squaredNorm() - r * r;
    plain_wrong += (pb * pb - u.squaredNorm() * pc >= 0.0) != truth;
    wrong += meet_ball({Eigen::Vector3d::Zero(), u}, c, r).has_value() != truth;
  }
  one.plain_error = static_cast<double>(plain_wrong) / std::max(tried, 1);
  one.our_error = tried > 0 ? static_cast<double>(wrong) / tried : 1.0;
  return one;
}

/// Thickness of the layer along its normal on a face that is nearly seen from the side.
HardCase steep_layer() {
  HardCase one{"thickness of the layer at slopes up to 89.99999999 degrees",
               "t / cos(atan(slope)), along z",
               "relative",
               0,
               0,
               4 * kEps};
  for (int i = 0; i < 200; ++i) {
    const double slope = std::pow(10.0, 8.0 * i / 199.0);
    FaceShape::Local local{};
    const double length = std::hypot(1.0, slope);
    local.view_point_mm.setZero();
    local.normal = {-slope / length, 0.0, 1.0 / length};
    local.cos_incline = 1.0 / length;
    const double layer = 1.5;
    const Eigen::Vector3d lifted = untouched_point_mm(local, layer, MappingAlong::kNormal);
    keep_worst(relative_error(exact::norm(lifted), layer), one.our_error);
    keep_worst(std::abs(layer / std::cos(std::atan(slope)) - layer) / layer, one.plain_error);
  }
  return one;
}

}  // namespace

std::vector<HardCase> hard_directions() {
  return {angular_radius(0.05, 1.5, "radius of a ball in the picture, 0.05 to 1.5 rad"),
          angular_radius(1e-4, 1e-2, "radius of a small ball, 1e-4 to 1e-2 rad"),
          angular_radius(1e-12, 1e-7, "radius of a speck, 1e-12 to 1e-7 rad"),
          grazing_ray(1e-4, 1e-13, "where a ray meets a ball, grazing by 1e-4"),
          grazing_ray(1e-10, 1e-11, "where a ray meets a ball, grazing by 1e-10"),
          rim_decision(),
          steep_layer()};
}

}  // namespace alltact
