// The lamps' power follows their supply; a frame integrates it over the exposure T.
//   mains: P(t) = 1 + depth cos(2 pi f t), of which the mean about t is
//          1 + depth sin(pi f T) / (pi f T) cos(2 pi f t); depth = (max - min) / (max + min), the
//          percent flicker of IEEE 1789-2015.
//   pwm:   on for the share `duty` of every period; a frame receives the on-time of its exposure
//          as a share of duty * T.
#include "core/simulation/effect.h"

#include <numbers>

namespace alltact {

namespace {

class Flicker final : public GeometryEffect {
 public:
  explicit Flicker(YamlSection& p)
      : pwm_(p.choice("kind", {"mains", "pwm"}) == 1),
        hz_(p.number("hz", strength_up_to(1e6))),
        exposure_s_(p.number("exposure_ms", strength_up_to(10000)) / 1000),
        depth_(pwm_ ? 0 : p.number("depth", strength_up_to(1))),
        duty_(pwm_ ? p.number("duty", {0, 1, true, true}) : 0) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.lamp_count == 0)
      return Error{en::say("there is no lamp that could flicker"), "",
                   en::say("name the effect leds too")};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    const double t = frame.time_s();
    geometry.illumination.lamp_share *= pwm_ ? pwm_mean(t) : mains_mean(t);
  }

 private:
  [[nodiscard]] double mains_mean(double t_s) const {
    const double half = std::numbers::pi * hz_ * exposure_s_;
    return 1 + depth_ * std::sin(half) / half * std::cos(2 * std::numbers::pi * hz_ * t_s);
  }
  [[nodiscard]] double pwm_mean(double t_s) const {
    const auto periods_on = [&](double t) {  // since time 0
      const double periods = t * hz_, full_periods = std::floor(periods);
      return full_periods * duty_ + std::min(periods - full_periods, duty_);
    };
    const double half = exposure_s_ / 2;
    return (periods_on(t_s + half) - periods_on(t_s - half)) / (hz_ * exposure_s_ * duty_);
  }

  bool pwm_;
  double hz_, exposure_s_, depth_, duty_;
};

}  // namespace

EffectKind effect_flicker() {
  return effect_kind<Flicker>("flicker", 72, en::say("The lamps flicker"),
                              "kind: mains, hz: 100, exposure_ms: 8, depth: 0.3", {"leds"});
}

}  // namespace alltact
