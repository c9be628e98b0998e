// One lamp is off in the frames with this effect. Lamps count from 0 in the order of the effect
// leds.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class DeadLamp final : public GeometryEffect {
 public:
  explicit DeadLamp(YamlSection& p) : lamp_(p.integer("lamp", 0, 1000)) {}

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    if (scene.lamp_count == 0)
      return Error{en::say("there is no lamp that could fail"), "",
                   en::say("name the effect leds too")};
    if (lamp_ >= scene.lamp_count)
      return Error{en::say("there is no lamp {}", lamp_), "",
                   en::say("0 to {}", scene.lamp_count - 1)};
    return {};
  }

  void apply(const FrameContext&, FrameGeometry& geometry) const override {
    geometry.illumination.single_share[lamp_] = 0;
  }

 private:
  int lamp_;
};

}  // namespace

EffectKind effect_dead_lamp() {
  return effect_kind<DeadLamp>("dead-lamp", 74, en::say("A lamp is off"), "lamp: 0", {"leds"});
}

}  // namespace alltact
