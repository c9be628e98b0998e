// The finger bends in the x-z plane with the deflection w along the undeformed face's normal, w(s)
// = q1 (s/L)^2 + q2 ((s/L)^3 - (s/L)^2), clamped at the base. The slope angle changes by w'(s); the
// length of the face does not change.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Bend final : public GeometryEffect {
 public:
  explicit Bend(YamlSection& p)
      : q1_(DegreeOfFreedom::read(p, "q1_mm", {-100, 100})),
        q2_(DegreeOfFreedom::read(p, "q2_mm", {-100, 100})) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{en::say("a flat sensor does not bend"), "", en::say("leave bend out")};
    return {};
  }
  std::vector<DegreeOfFreedom> degrees_of_freedom() const override { return {q1_, q2_}; }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    curve.bend(frame(q1_), frame(q2_));
  }

 private:
  DegreeOfFreedom q1_, q2_;
};

}  // namespace

EffectKind effect_bend() {
  return effect_kind<Bend>("bend", 10, en::say("The finger bends in the plane of its length"),
                           "q1_mm: {from: -5, to: 5}, q2_mm: {from: -4, to: 4}");
}

}  // namespace alltact
