// Room light enters the finger and falls on its faces from all directions. They reflect light *
// (level + sum over the lamps), `level` in grey levels of a perfectly white surface.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Ambient final : public GeometryEffect {
 public:
  explicit Ambient(YamlSection& p) : level_(Varying::read(p, "level", strength_up_to(1e4))) {}

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("leds"))
      return Error{en::say("room light adds to the light of the lamps"), "",
                   en::say("name the effect leds too")};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    geometry.illumination.room_level += frame(level_);
  }

 private:
  Varying level_;
};

}  // namespace

EffectKind effect_ambient() {
  return effect_kind<Ambient>("ambient", 71, en::say("Room light falls on the faces"), "level: 5",
                              {"leds"});
}

}  // namespace alltact
