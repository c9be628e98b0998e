// Read noise: normal, `sd` grey levels, the same in every pixel.
#include "core/numerics/dispatch.h"
#include "core/simulation/noise.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_read(int n,
                           float sd,
                           const float* __restrict normal,
                           float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += sd * normal[u];
}

}  // namespace

const EffectKind& effect_read() {
  static const EffectKind kKind{"read",
                                Stage::kSensor,
                                60,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<NoiseEffect>(
                                      "read",
                                      p.number("sd", strength_up_to(100)),
                                      add_read,
                                      en::say("Reading the sensor adds noise"));
                                },
                                "sd: 1"};
  return kKind;
}

}  // namespace alltact
