// The finger leans sideways: its middle line shifts in y by sway (s/L)^2.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Sway final : public GeometryEffect {
 public:
  explicit Sway(YamlSection& p) : sway_(DegreeOfFreedom::read(p, "sway_mm", {-100, 100})) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{en::say("a flat sensor does not sway"), "", en::say("leave sway out")};
    return {};
  }
  std::vector<DegreeOfFreedom> degrees_of_freedom() const override { return {sway_}; }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    curve.sway(frame(sway_));
  }

 private:
  DegreeOfFreedom sway_;
};

}  // namespace

EffectKind effect_sway() {
  return effect_kind<Sway>("sway", 11, en::say("The finger leans sideways"),
                           "sway_mm: {from: -2, to: 2}");
}

}  // namespace alltact
