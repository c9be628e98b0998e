// A hole in the black coat admits room light: light = light + level * part, part the share of the
// pixel that a disc of `radius_mm` about (s_mm, y_mm) covers, `level` in grey levels.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Hole final : public RadianceEffect {
 public:
  explicit Hole(YamlSection& p)
      : s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        radius_(Varying::read(p, "radius_mm", strength_up_to(50))),
        level_(Varying::read(p, "level", strength_up_to(1e4))) {}

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override { return check_position(scene, s_, y_); }

  Rows begin(const FrameContext& frame, const FrameGeometry& geometry) const override {
    const Eigen::Vector2d at(frame(s_), frame(y_));
    return [&camera = geometry.rays().camera(), mark = FaceMark{at, at, frame(radius_)},
            level = frame(level_)](RowView& row) { mark_row(camera, mark, 1, level, row); };
  }

 private:
  Varying s_, y_, radius_, level_;
};

}  // namespace

EffectKind effect_hole() {
  return effect_kind<Hole>("hole", 55, en::say("Light comes through a hole in the coat"),
                           "s_mm: 60, y_mm: -3, radius_mm: 0.4, level: 90");
}

}  // namespace alltact
