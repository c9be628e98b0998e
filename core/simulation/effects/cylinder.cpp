// A cylinder lies on the face, its axis along the finger's length unless rotated: gap(y) = R -
// sqrt(R^2 - y^2) for |x| <= length / 2.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

namespace alltact {

namespace {

class CylinderBody final : public HeightField {
 public:
  CylinderBody(double radius_mm, double length_mm) : radius_mm_(radius_mm), length_mm_(length_mm) {}
  double gap_mm(double x, double y) const override {
    const double up2 = radius_mm_ * radius_mm_ - y * y;
    if (up2 < 0 || std::abs(x) > length_mm_ / 2) return kNothing_mm;
    return y * y / (radius_mm_ + std::sqrt(up2));  // avoids the cancellation of the difference
  }
  Eigen::Vector2d half_size_mm() const override { return {length_mm_ / 2, radius_mm_}; }

 private:
  double radius_mm_, length_mm_;
};

class Cylinder final : public RigidPress {
 public:
  explicit Cylinder(YamlSection& p) : RigidPress(p) {
    const double radius = p.number("radius_mm", strength_up_to(100));
    set_body(std::make_shared<CylinderBody>(radius, p.number("length_mm", strength_up_to(200))));
  }
  Message sentence() const override { return en::say("A cylinder is pressed in sideways"); }
};

}  // namespace

const EffectKind& effect_cylinder() {
  static const EffectKind kKind{
      "cylinder",
      Stage::kGeometry,
      32,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Cylinder>(p); },
      "radius_mm: 4, length_mm: 12, s_mm: 50, y_mm: 0, depth_mm: 0.8"};
  return kKind;
}

}  // namespace alltact
