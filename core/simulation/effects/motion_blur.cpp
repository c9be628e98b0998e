// Motion blur: the image is the mean light while the shutter is open, I = (1 / n) sum I(t_i), t_i
// the middles of `moments` equal parts of `exposure_ms` about the frame's time. Between frames
// everything that varies is interpolated linearly.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class MotionBlur final : public SensorEffect {
 public:
  explicit MotionBlur(YamlSection& p)
      : exposure_s_(p.number("exposure_ms", strength_up_to(10000)) / 1000),
        moments_(p.integer_or("moments", 5, 2, 100)) {}

  Status validate(const SceneFacts& scene) const override {
    if (exposure_s_ * scene.frames_per_s > 1)
      return Error{en::say("the shutter would be open for longer than a frame lasts"), "",
                   en::say("exposure_ms up to {:g}", 1000 / scene.frames_per_s)};
    return {};
  }
  void expose(const SceneFacts& scene, Exposure& exposure) const override {
    exposure.open = exposure_s_ * scene.frames_per_s;
    exposure.moments = moments_;
  }

 private:
  double exposure_s_;
  int moments_;
};

}  // namespace

EffectKind effect_motion_blur() {
  return effect_kind<MotionBlur>("motion-blur", 1, en::say("The finger moves during the exposure"),
                                 "exposure_ms: 10");
}

}  // namespace alltact
