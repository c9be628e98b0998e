// An edge, as of a box or a blade: two planes that form `angle_deg`, rounded by `radius_mm`. Their
// line lies along the finger's length unless rotated:
//   gap(y) = r - sqrt(r^2 - y^2)                 for |y| <= r cos(a), a half of the angle,
//   gap(y) = r (1 - 1 / sin a) + |y| / tan a     beyond, for |x| <= length / 2.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

#include <numbers>

namespace alltact {

namespace {

constexpr double kHighest_mm = 20;  // height of an edge: above any layer's thickness

std::shared_ptr<const Body> edge_body(YamlSection& p) {
  const double half_rad = p.number("angle_deg", {10, 170}) * std::numbers::pi / 360;
  const double radius = p.number_or("radius_mm", 0, strength_up_to(20));
  const double length = p.number("length_mm", strength_up_to(200));
  const auto gap_mm = [half_rad, radius, length](double x, double y) {
    if (std::abs(x) > length / 2) return HeightField::kNothing_mm;
    const double sin = std::sin(half_rad), cos = std::cos(half_rad), far = std::abs(y);
    if (far <= radius * cos)
      return far * far / (radius + std::sqrt(radius * radius - far * far) + 1e-300);
    return radius * (1 - 1 / sin) + far * cos / sin;
  };
  return std::make_shared<HeightField>(
      gap_mm, Eigen::Vector2d(length / 2, kHighest_mm * std::tan(half_rad) + radius));
}

}  // namespace

EffectKind effect_edge() {
  return effect_kind<RigidPressOf<edge_body>>(
      "edge", 33, en::say("An edge is pressed into the face"),
      "angle_deg: 90, radius_mm: 0.2, length_mm: 14, rotation_deg: 30, s_mm: 50, y_mm: 0, "
      "depth_mm: 0.7");
}

}  // namespace alltact
