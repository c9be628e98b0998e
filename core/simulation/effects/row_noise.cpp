// Every row of every frame has its own offset: I = I + sd n, n standard normal (the row temporal
// noise of EMVA 1288, release 4).
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_row_offset(int n, float offset, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += offset;
}

class RowOffsets final : public SensorEffect {
 public:
  explicit RowOffsets(YamlSection& p)
      : sd_(static_cast<float>(p.number("sd", strength_up_to(100)))), noise_("row-noise") {}

  Message sentence() const override {
    return en::say("Every row is a little brighter or darker, differently in each frame");
  }

  void row(const FrameContext& frame, RowView& row) const override {
    float normal = 0;
    noise_.normals(frame.seed, frame.frame, row.v, 1, &normal);
    add_row_offset(row.width, sd_ * normal, row.value);
  }

 private:
  float sd_;
  RowNoise noise_;
};

}  // namespace

const EffectKind& effect_row_noise() {
  static const EffectKind kKind{"row-noise",
                                Stage::kSensor,
                                61,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<RowOffsets>(p);
                                },
                                "sd: 0.5"};
  return kKind;
}

}  // namespace alltact
