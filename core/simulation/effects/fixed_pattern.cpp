// Every pixel has its own gain and offset, the same in all frames: I = I (1 + prnu n) + dsnu m, n
// and m independent and standard normal (EMVA 1288: photo response and dark signal non-uniformity).
// `prnu` is a share, `dsnu` in grey levels; either may be left out.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void apply_prnu(int n, float prnu, const float* __restrict normal,
                             float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += value[u] * prnu * normal[u];
}
ALLTACT_WIDE void add_dsnu(int n, float dsnu, const float* __restrict normal,
                           float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += dsnu * normal[u];
}

class FixedPattern final : public SensorEffect {
 public:
  explicit FixedPattern(YamlSection& p)
      : prnu_(static_cast<float>(p.number_or("prnu", 0, strength_up_to(0.2)))),
        dsnu_(static_cast<float>(p.number_or("dsnu", 0, strength_up_to(100)))),
        gain_noise_("fixed-pattern.prnu"),
        offset_noise_("fixed-pattern.dsnu") {
    if (prnu_ == 0 && dsnu_ == 0)
      p.refuse("", en::say("there is neither prnu nor dsnu"), en::say("name one of them"));
  }

  void row(const FrameContext& frame, RowView& row) const override {
    float* normal = row.scratch.floats();
    if (prnu_ > 0) {
      gain_noise_.normals(frame.seed, 0, row.v, row.width, normal);
      apply_prnu(row.width, prnu_, normal, row.value);
    }
    if (dsnu_ > 0) {
      offset_noise_.normals(frame.seed, 0, row.v, row.width, normal);
      add_dsnu(row.width, dsnu_, normal, row.value);
    }
  }

 private:
  float prnu_, dsnu_;
  RowNoise gain_noise_, offset_noise_;
};

}  // namespace

EffectKind effect_fixed_pattern() {
  return effect_kind<FixedPattern>(
      "fixed-pattern", 45,
      en::say("Every pixel is always a little brighter or darker than its neighbours"),
      "prnu: 0.01, dsnu: 0.3");
}

}  // namespace alltact
