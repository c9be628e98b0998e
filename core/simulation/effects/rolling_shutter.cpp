// The sensor reads its rows one after the other: row v of h is exposed at t + readout_ms (v / (h -
// 1) - 1 / 2), t the frame's time. With `rows_at_once` that many neighbouring rows share the time
// of their middle, which reduces the cost by that factor.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class RollingShutter final : public SensorEffect {
 public:
  explicit RollingShutter(YamlSection& p)
      : readout_s_(p.number("readout_ms", strength_up_to(10000)) / 1000),
        rows_at_once_(p.integer_or("rows_at_once", 1, 1, 1000)) {}

  Status validate(const SceneFacts& scene) const override {
    if (readout_s_ * scene.frames_per_s > 1)
      return Error{en::say("reading the rows would take longer than a frame lasts"), "",
                   en::say("readout_ms up to {:g}", 1000 / scene.frames_per_s)};
    return {};
  }
  void expose(const SceneFacts& scene, Exposure& exposure) const override {
    exposure.readout = readout_s_ * scene.frames_per_s;
    exposure.rows_at_once = rows_at_once_;
  }

 private:
  double readout_s_;
  int rows_at_once_;
};

}  // namespace

EffectKind effect_rolling_shutter() {
  return effect_kind<RollingShutter>(
      "rolling-shutter", 2, en::say("The rows of an image are exposed one after the other"),
      "readout_ms: 16, rows_at_once: 8");
}

}  // namespace alltact
