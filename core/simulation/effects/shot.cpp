// Shot noise: variance gain * (grey level), normal.
#include "core/numerics/dispatch.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_shot(int n, float gain, const float* __restrict normal,
                           float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += std::sqrt(gain * std::max(value[u], 0.0F)) * normal[u];
}

class ShotNoise final : public NoiseEffect {
 public:
  explicit ShotNoise(YamlSection& p)
      : NoiseEffect("shot", p.number("gain", strength_up_to(100)), add_shot) {}
};

}  // namespace

EffectKind effect_shot() {
  return effect_kind<ShotNoise>(
      "shot", 50, en::say("Light arrives as photons; their noise grows with brightness"),
      "gain: 0.03");
}

}  // namespace alltact
