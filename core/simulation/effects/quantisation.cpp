// The sensor counts in integer grey levels from 0 to 255.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

ALLTACT_WIDE void quantise(int first, int last, const float* __restrict value,
                           std::uint8_t* __restrict bytes) {
  for (int u = first; u < last; ++u) {
    const float level = std::min(std::max(value[u], 0.0F), 255.0F);
    bytes[u] = static_cast<std::uint8_t>(static_cast<int>(level + 0.5F));
  }
}

class Quantisation final : public SensorEffect {
 public:
  explicit Quantisation(YamlSection&) {}
  bool outputs_bytes() const override { return true; }
  void row(const FrameContext&, RowView& row) const override {
    std::fill(row.bytes, row.bytes + row.lit_first, std::uint8_t{0});
    quantise(row.lit_first, row.lit_last, row.value, row.bytes);
    std::fill(row.bytes + row.lit_last, row.bytes + row.width, std::uint8_t{0});
  }
};

}  // namespace

EffectKind effect_quantisation() {
  return effect_kind<Quantisation>(
      "quantisation", 90, en::say("The sensor outputs integer grey levels from 0 to 255"), "");
}

}  // namespace alltact
