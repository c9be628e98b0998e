// Shot noise: variance gain * (grey level), normal.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add(int n, float gain, const float* __restrict normal, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += std::sqrt(gain * std::max(value[u], 0.0F)) * normal[u];
}

class Shot final : public SensorEffect {
 public:
  explicit Shot(Parameters& p)
      : gain_(static_cast<float>(p.number("gain", strength_up_to(100)))), noise_("shot") {}
  void row(const FrameContext& frame, RowView& row) const override {
    float* normal = row.scratch.floats();
    noise_.normals(frame.seed, frame.frame, row.v, row.width, normal);
    add(row.width, gain_, normal, row.value);
  }

 private:
  float gain_;
  RowNoise noise_;
};

}  // namespace

const EffectKind& effect_shot() {
  static const EffectKind kKind{
      "shot", Stage::kSensor, 50, [](Parameters& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<Shot>(p);
      }};
  return kKind;
}

}  // namespace alltact
