// The clear body between lamps, face and camera absorbs: the light of each lamp falls by
// exp(-per_mm (r_l + r_c)), r_l the way from the lamp to the face and r_c that on to the camera
// (Beer, Lambert). Room light stays.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Absorption final : public GeometryEffect {
 public:
  explicit Absorption(YamlSection& p) : per_mm_(p.number("per_mm", strength_up_to(1))) {}

  Message sentence() const override { return en::say("The silicone absorbs light on its way"); }

  Status fits(const SceneFacts& scene) const override {
    if (!scene.names("leds"))
      return Error{en::say("there is no lamp whose light could be absorbed"),
                   "",
                   en::say("name the effect leds too")};
    return {};
  }

  void place(const FrameContext&, FrameGeometry& geometry) const override {
    geometry.illumination.absorb_per_mm = per_mm_;
  }

 private:
  double per_mm_;
};

}  // namespace

const EffectKind& effect_absorption() {
  static const EffectKind kKind{"absorption",
                                Stage::kGeometry,
                                70,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<Absorption>(p);
                                },
                                "per_mm: 0.003",
                                {"leds"}};
  return kKind;
}

}  // namespace alltact
