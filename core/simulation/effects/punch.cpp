// A flat punch: a round plate with upright walls.
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

namespace alltact {

namespace {

class PunchBody final : public HeightField {
 public:
  explicit PunchBody(double radius_mm) : radius_mm_(radius_mm) {}
  double gap_mm(double x, double y) const override {
    return x * x + y * y <= radius_mm_ * radius_mm_ ? 0.0 : kNothing_mm;
  }
  Eigen::Vector2d half_size_mm() const override { return {radius_mm_, radius_mm_}; }

 private:
  double radius_mm_;
};

class Punch final : public RigidPress {
 public:
  explicit Punch(YamlSection& p) : RigidPress(p) {
    set_body(std::make_shared<PunchBody>(p.number("radius_mm", strength_up_to(100))));
  }
  Message sentence() const override { return en::say("A flat punch is pressed into the face"); }
};

}  // namespace

const EffectKind& effect_punch() {
  static const EffectKind kKind{
      "punch",
      Stage::kGeometry,
      34,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Punch>(p); },
      "radius_mm: 3, s_mm: 50, y_mm: 0, depth_mm: 0.5"};
  return kKind;
}

}  // namespace alltact
