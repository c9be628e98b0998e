// The sensor counts from `level` grey levels instead of from 0: I = I + level.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_black_level(int n, float level, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += level;
}

class BlackLevel final : public SensorEffect {
 public:
  explicit BlackLevel(YamlSection& p) : level_(Varying::read(p, "level", strength_up_to(255))) {}

  Message sentence() const override { return en::say("The sensor adds a constant to every pixel"); }

  void row(const FrameContext& frame, RowView& row) const override {
    add_black_level(row.width, static_cast<float>(frame(level_)), row.value);
  }

 private:
  Varying level_;
};

}  // namespace

const EffectKind& effect_black_level() {
  static const EffectKind kKind{"black-level",
                                Stage::kSensor,
                                70,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<BlackLevel>(p);
                                },
                                "level: 4"};
  return kKind;
}

}  // namespace alltact
