// A cylinder lies on the face, its axis along the finger's length unless rotated: gap(y) = R -
// sqrt(R^2 - y^2) for |x| <= length / 2.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

namespace alltact {

namespace {

std::shared_ptr<const Body> cylinder_body(YamlSection& p) {
  const double radius = p.number("radius_mm", strength_up_to(100));
  const double length = p.number("length_mm", strength_up_to(200));
  const auto gap_mm = [radius, length](double x, double y) {
    const double up2 = radius * radius - y * y;
    if (up2 < 0 || std::abs(x) > length / 2) return HeightField::kNothing_mm;
    return y * y / (radius + std::sqrt(up2));  // avoids the cancellation of the difference
  };
  return std::make_shared<HeightField>(gap_mm, Eigen::Vector2d(length / 2, radius));
}

}  // namespace

EffectKind effect_cylinder() {
  return effect_kind<RigidPressOf<cylinder_body>>(
      "cylinder", 32, en::say("A cylinder is pressed in sideways"),
      "radius_mm: 4, length_mm: 12, s_mm: 50, y_mm: 0, depth_mm: 0.8");
}

}  // namespace alltact
