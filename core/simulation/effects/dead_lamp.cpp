// One lamp gives no light: from the start, or from `from_s` after frame 0 on. Lamps are counted
// from 0 in the order of the effect leds.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class DeadLamp final : public GeometryEffect {
 public:
  explicit DeadLamp(YamlSection& p)
      : lamp_(p.whole_number("lamp", 0, 1000)), from_s_(p.number_or("from_s", 0, {0, 1e6})) {}

  Message sentence() const override { return en::say("A lamp is off"); }
  bool may_be_several() const override { return true; }

  Status fits(const SceneFacts& scene) const override {
    if (scene.lamp_count == 0)
      return Error{
          en::say("there is no lamp that could fail"), "", en::say("name the effect leds too")};
    if (lamp_ >= scene.lamp_count)
      return Error{
          en::say("there is no lamp {}", lamp_), "", en::say("0 to {}", scene.lamp_count - 1)};
    return {};
  }

  void place(const FrameContext& frame, FrameGeometry& geometry) const override {
    if (frame.time_s() >= from_s_) geometry.illumination.single_share[lamp_] = 0;
  }

 private:
  int lamp_;
  double from_s_;
};

}  // namespace

const EffectKind& effect_dead_lamp() {
  static const EffectKind kKind{
      "dead-lamp",
      Stage::kGeometry,
      74,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<DeadLamp>(p); },
      "lamp: 0",
      {"leds"}};
  return kKind;
}

}  // namespace alltact
