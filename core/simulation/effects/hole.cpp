// A hole in the black coat admits room light: light = light + level * part, part the share of the
// pixel that a disc of `radius_mm` about (s_mm, y_mm) covers, `level` in grey levels.
#include "core/simulation/effect.h"
#include "core/simulation/face_mark.h"

namespace alltact {

namespace {

class Hole final : public RadianceEffect {
 public:
  explicit Hole(YamlSection& p)
      : s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        radius_(Varying::read(p, "radius_mm", strength_up_to(50))),
        level_(Varying::read(p, "level", strength_up_to(1e4))) {}

  Message sentence() const override { return en::say("Light comes through a hole in the coat"); }
  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override { return check_position(scene, s_, y_); }

  std::unique_ptr<const Rows> begin(const FrameContext& frame,
                                    const FrameGeometry& geometry) const override {
    const Eigen::Vector2d at(frame(s_), frame(y_));
    return std::make_unique<MarkRows>(geometry, FaceMark{at, at, frame(radius_)}, 1, frame(level_));
  }

 private:
  Varying s_, y_, radius_, level_;
};

}  // namespace

const EffectKind& effect_hole() {
  static const EffectKind kKind{
      "hole",
      Stage::kRadiance,
      55,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Hole>(p); },
      "s_mm: 60, y_mm: -3, radius_mm: 0.4, level: 90"};
  return kKind;
}

}  // namespace alltact
