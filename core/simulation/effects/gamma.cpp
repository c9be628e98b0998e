// The camera's tone curve: I = 255 (I / 255)^(1 / gamma), 0 below 0.
#include "core/numerics/dispatch.h"
#include "core/numerics/vector_loops.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

ALLTACT_WIDE void apply_gamma(int n, float power, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] = 255.0F * vector_pow(value[u] / 255.0F, power);
}

class Gamma final : public SensorEffect {
 public:
  explicit Gamma(YamlSection& p) : gamma_(p.number("gamma", {0.1, 10})) {
    if (gamma_ == 1)
      p.refuse("gamma", en::say("gamma 1 changes nothing"), en::say("leave gamma out"));
  }

  void row(const FrameContext&, RowView& row) const override {
    apply_gamma(row.width, static_cast<float>(1 / gamma_), row.value);
  }

 private:
  double gamma_;
};

}  // namespace

EffectKind effect_gamma() {
  return effect_kind<Gamma>("gamma", 80, en::say("The camera's grey levels follow a power law"),
                            "gamma: 2.2");
}

}  // namespace alltact
