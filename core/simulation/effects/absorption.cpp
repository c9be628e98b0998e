// The clear body between lamps, face and camera absorbs. The light of each lamp falls by
// exp(-per_mm (r_l + r_c)), r_l the path length from the lamp to the face and r_c that on to the
// camera (Beer, Lambert). Room light is unchanged.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Absorption final : public GeometryEffect {
 public:
  explicit Absorption(YamlSection& p) : per_mm_(p.number("per_mm", strength_up_to(1))) {}

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("leds"))
      return Error{en::say("there is no lamp whose light could be absorbed"), "",
                   en::say("name the effect leds too")};
    return {};
  }

  void apply(const FrameContext&, FrameGeometry& geometry) const override {
    geometry.illumination.absorb_per_mm = per_mm_;
  }

 private:
  double per_mm_;
};

}  // namespace

EffectKind effect_absorption() {
  return effect_kind<Absorption>("absorption", 70,
                                 en::say("The silicone absorbs part of the light"), "per_mm: 0.003",
                                 {"leds"});
}

}  // namespace alltact
