// The camera's gain drifts slowly: I = I (1 + sd g(t)). g is a normal process of variance 1 at any
// time: g = n_k cos(pi f / 2) + n_(k+1) sin(pi f / 2), k the integer part and f the fraction of
// (seconds since frame 0) / `every_s`, n_k independent and standard normal.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

#include <numbers>

namespace alltact {

namespace {

ALLTACT_WIDE void apply_gain(int n, float gain, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] *= gain;
}

class GainDrift final : public SensorEffect {
 public:
  explicit GainDrift(YamlSection& p)
      : sd_(p.number("sd", strength_up_to(0.2))),
        every_s_(p.number("every_s", strength_up_to(1e6))),
        noise_("gain-drift") {}

  void row(const FrameContext& frame, RowView& row) const override {
    const double knots = frame.time_s() / every_s_;
    const int k = static_cast<int>(knots);
    const double angle = std::numbers::pi / 2 * (knots - k);
    const double g =
        normal(frame.seed, k) * std::cos(angle) + normal(frame.seed, k + 1) * std::sin(angle);
    apply_gain(row.width, static_cast<float>(1 + sd_ * g), row.value);
  }

 private:
  [[nodiscard]] double normal(std::uint64_t seed, int k) const {
    float value = 0;
    noise_.normals(seed, k, 0, 1, &value);
    return value;
  }

  double sd_, every_s_;
  RowNoise noise_;
};

}  // namespace

EffectKind effect_gain_drift() {
  return effect_kind<GainDrift>("gain-drift", 65,
                                en::say("The camera's gain drifts from frame to frame"),
                                "sd: 0.02, every_s: 10");
}

}  // namespace alltact
