// A speck of dirt on the view face darkens it: light = light (1 - darkness * part), part the share
// of the pixel that a disc of `radius_mm` about (s_mm, y_mm) covers.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Speck final : public RadianceEffect {
 public:
  explicit Speck(YamlSection& p)
      : s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        radius_(Varying::read(p, "radius_mm", strength_up_to(50))),
        darkness_(p.number("darkness", strength_up_to(1))) {}

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override { return check_position(scene, s_, y_); }

  Rows begin(const FrameContext& frame, const FrameGeometry& geometry) const override {
    const Eigen::Vector2d at(frame(s_), frame(y_));
    return [this, &camera = geometry.rays().camera(), mark = FaceMark{at, at, frame(radius_)}](
               RowView& row) { mark_row(camera, mark, 1 - darkness_, 0, row); };
  }

 private:
  Varying s_, y_, radius_;
  double darkness_;
};

}  // namespace

EffectKind effect_speck() {
  return effect_kind<Speck>("speck", 15, en::say("A speck of dirt is on the face"),
                            "s_mm: 40, y_mm: 2, radius_mm: 0.5, darkness: 0.5");
}

}  // namespace alltact
