// Read noise: the same in every pixel, `sd` grey levels, normal.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add(int n, float sd, const float* __restrict normal, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += sd * normal[u];
}

class Read final : public SensorEffect {
 public:
  explicit Read(Parameters& p)
      : sd_(static_cast<float>(p.number("sd", strength_up_to(100)))), noise_("read") {}
  void row(const FrameContext& frame, RowView& row) const override {
    float* normal = row.scratch.floats();
    noise_.normals(frame.seed, frame.frame, row.v, row.width, normal);
    add(row.width, sd_, normal, row.value);
  }

 private:
  float sd_;
  RowNoise noise_;
};

}  // namespace

const EffectKind& effect_read() {
  static const EffectKind kKind{
      "read", Stage::kSensor, 60, [](Parameters& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<Read>(p);
      }};
  return kKind;
}

}  // namespace alltact
