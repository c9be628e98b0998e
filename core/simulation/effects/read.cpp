// Read noise: normal, `sd` grey levels, the same in every pixel.
#include "core/numerics/dispatch.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_read(int n, float sd, const float* __restrict normal,
                           float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += sd * normal[u];
}

class ReadNoise final : public NoiseEffect {
 public:
  explicit ReadNoise(YamlSection& p)
      : NoiseEffect("read", p.number("sd", strength_up_to(100)), add_read) {}
};

}  // namespace

EffectKind effect_read() {
  return effect_kind<ReadNoise>("read", 60, en::say("Reading the sensor adds noise"), "sd: 1");
}

}  // namespace alltact
