// A scratch in the view face: light = light (1 + change * part), part the share of the pixel within
// `width_mm` / 2 of the line from `from_mm` to `to_mm`, each [s, y]. change 1 doubles the light, -1
// removes it.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Scratch final : public RadianceEffect {
 public:
  explicit Scratch(YamlSection& p)
      : from_(point(p, "from_mm")),
        to_(point(p, "to_mm")),
        width_mm_(p.number("width_mm", strength_up_to(50))),
        change_(p.number("change", {-1, 10, false, false, true})) {}

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    for (const Eigen::Vector2d& end : {from_, to_})
      if (const Status status = check_position(scene, Varying(end.x()), Varying(end.y())); !status)
        return status;
    return {};
  }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    return [this, &camera = geometry.rays().camera()](RowView& row) {
      mark_row(camera, {from_, to_, width_mm_ / 2}, 1 + change_, 0, row);
    };
  }

 private:
  static Eigen::Vector2d point(YamlSection& p, const char* key) {
    const auto at = p.numbers(key, 2, 2, {-1000, 1000});
    return {at[0], at[1]};
  }

  Eigen::Vector2d from_, to_;
  double width_mm_, change_;
};

}  // namespace

EffectKind effect_scratch() {
  return effect_kind<Scratch>("scratch", 16, en::say("A scratch crosses the face"),
                              "from_mm: [30, -4], to_mm: [50, 5], width_mm: 0.3, change: 0.4");
}

}  // namespace alltact
