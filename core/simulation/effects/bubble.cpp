// An air bubble in the layer. A sphere of `radius_mm` about (s_mm, y_mm) scatters nothing: at
// distance r from its centre the layer is thinner by 2 sqrt(radius^2 - r^2) along its normal. The
// outer side does not move.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Bubble final : public RadianceEffect {
 public:
  explicit Bubble(YamlSection& p)
      : s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        radius_(Varying::read(p, "radius_mm", strength_up_to(25))) {}

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("layer"))
      return Error{en::say("the bubble needs a layer"), "", en::say("name the effect layer too")};
    if (2 * radius_.max_value() > scene.finger.face.layer_mm)
      return Error{en::say("the bubble is wider than the layer is thick"), "",
                   en::say("radius_mm up to {:g}", scene.finger.face.layer_mm / 2)};
    return check_position(scene, s_, y_);
  }

  Rows begin(const FrameContext& frame, const FrameGeometry&) const override {
    return [s_mm = frame(s_), y_mm = frame(y_), radius_mm = frame(radius_)](RowView& row) {
      const FaceRow& face = row.face;
      for (int u = face.first; u < face.last; ++u) {
        const double s = face.s_mm[u] - s_mm, y = face.y_mm[u] - face.shift_mm[u] - y_mm;
        const double h2 = radius_mm * radius_mm - s * s - y * y;
        if (h2 <= 0) continue;
        if (!row.hollow_mm) {
          row.hollow_mm = row.scratch.floats();
          std::fill(row.hollow_mm + face.first, row.hollow_mm + face.last, 0.0F);
        }
        row.hollow_mm[u] += static_cast<float>(2 * std::sqrt(h2));
      }
    };
  }

 private:
  Varying s_, y_, radius_;
};

}  // namespace

EffectKind effect_bubble() {
  return effect_kind<Bubble>("bubble", 5, en::say("A bubble of air makes the layer thinner"),
                             "s_mm: 45, y_mm: -2, radius_mm: 0.5", {"layer"});
}

}  // namespace alltact
