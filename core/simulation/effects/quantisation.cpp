// The sensor counts in whole grey levels from 0 to 255.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

ALLTACT_WIDE void quantise(int n, const float* __restrict value, std::uint8_t* __restrict bytes) {
  for (int u = 0; u < n; ++u) {
    const float level = std::min(std::max(value[u], 0.0F), 255.0F);
    bytes[u] = static_cast<std::uint8_t>(static_cast<int>(level + 0.5F));
  }
}

class Quantisation final : public SensorEffect {
 public:
  explicit Quantisation(YamlSection&) {}
  Message sentence() const override {
    return en::say("The sensor counts in whole grey levels from 0 to 255");
  }
  bool gives_bytes() const override { return true; }
  void row(const FrameContext&, RowView& row) const override {
    quantise(row.width, row.value, row.bytes);
  }
};

}  // namespace

const EffectKind& effect_quantisation() {
  static const EffectKind kKind{"quantisation",
                                Stage::kSensor,
                                90,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<Quantisation>(p);
                                },
                                ""};
  return kKind;
}

}  // namespace alltact
