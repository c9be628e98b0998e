// A flat punch: a round plate with upright walls.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

namespace alltact {

namespace {

std::shared_ptr<const Body> punch_body(YamlSection& p) {
  const double radius = p.number("radius_mm", strength_up_to(100));
  const auto gap_mm = [radius](double x, double y) {
    return x * x + y * y <= radius * radius ? 0.0 : HeightField::kNothing_mm;
  };
  return std::make_shared<HeightField>(gap_mm, Eigen::Vector2d(radius, radius));
}

}  // namespace

EffectKind effect_punch() {
  return effect_kind<RigidPressOf<punch_body>>("punch", 34,
                                               en::say("A flat punch is pressed into the face"),
                                               "radius_mm: 3, s_mm: 50, y_mm: 0, depth_mm: 0.5");
}

}  // namespace alltact
