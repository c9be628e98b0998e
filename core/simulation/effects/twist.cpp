// The finger twists: the section at s rotates about the middle line by twist s/L, like a clamped
// bar under a torque at its tip. A positive twist moves the edge at +y away from the camera.
#include "core/simulation/effect.h"

#include <numbers>

namespace alltact {

namespace {

class Twist final : public GeometryEffect {
 public:
  explicit Twist(YamlSection& p) : twist_(DegreeOfFreedom::read(p, "twist_deg", {-60, 60})) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{en::say("a flat sensor does not twist"), "", en::say("leave twist out")};
    return {};
  }
  std::vector<DegreeOfFreedom> degrees_of_freedom() const override { return {twist_}; }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    curve.twist(frame(twist_) * std::numbers::pi / 180);
  }

 private:
  DegreeOfFreedom twist_;
};

}  // namespace

EffectKind effect_twist() {
  return effect_kind<Twist>("twist", 12, en::say("The finger twists about its length"),
                            "twist_deg: {from: -8, to: 8}");
}

}  // namespace alltact
