// The lamps lose power as they warm up: P(t) = 1 - loss (1 - exp(-t / after_s)), t since frame 0.
// This is the step response of one heat capacity with one heat path.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Warming final : public GeometryEffect {
 public:
  explicit Warming(YamlSection& p)
      : loss_(p.number("loss", {0, 1, true, true, true})),
        after_s_(p.number("after_s", strength_up_to(1e6))) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.lamp_count == 0)
      return Error{en::say("there is no lamp that could warm up"), "",
                   en::say("name the effect leds too")};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    const double t = std::max(0.0, frame.time_s());
    geometry.illumination.lamp_share *= 1 + loss_ * std::expm1(-t / after_s_);
  }

 private:
  double loss_, after_s_;
};

}  // namespace

EffectKind effect_warming() {
  return effect_kind<Warming>("warming", 73, en::say("The lamps lose light while they warm up"),
                              "loss: 0.1, after_s: 60", {"leds"});
}

}  // namespace alltact
