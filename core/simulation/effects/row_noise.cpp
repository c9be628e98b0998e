// Every row of every frame has its own offset: I = I + sd n, n standard normal (the row temporal
// noise of EMVA 1288, release 4).
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

class RowOffsets final : public SensorEffect {
 public:
  explicit RowOffsets(YamlSection& p)
      : sd_(static_cast<float>(p.number("sd", strength_up_to(100)))), noise_("row-noise") {}

  void row(const FrameContext& frame, RowView& row) const override {
    float normal = 0;
    noise_.normals(frame.seed, frame.frame, row.v, 1, &normal);
    add_to_row(row, sd_ * normal);
  }

 private:
  float sd_;
  RowNoise noise_;
};

}  // namespace

EffectKind effect_row_noise() {
  return effect_kind<RowOffsets>(
      "row-noise", 61,
      en::say("Every row is a little brighter or darker, differently in each frame"), "sd: 0.5");
}

}  // namespace alltact
