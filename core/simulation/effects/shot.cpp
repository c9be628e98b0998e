// Shot noise: variance gain * (grey level), normal.
#include "core/numerics/dispatch.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_shot(int n,
                           float gain,
                           const float* __restrict normal,
                           float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += std::sqrt(gain * std::max(value[u], 0.0F)) * normal[u];
}

}  // namespace

const EffectKind& effect_shot() {
  static const EffectKind kKind{
      "shot",
      Stage::kSensor,
      50,
      [](YamlSection& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<NoiseEffect>(
            "shot",
            p.number("gain", strength_up_to(100)),
            add_shot,
            en::say("Light arrives as photons; their noise grows with brightness"));
      },
      "gain: 0.03"};
  return kKind;
}

}  // namespace alltact
