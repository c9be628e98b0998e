// The sensor counts from `level` grey levels instead of from 0: I = I + level.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class BlackLevel final : public SensorEffect {
 public:
  explicit BlackLevel(YamlSection& p) : level_(Varying::read(p, "level", strength_up_to(255))) {}

  void row(const FrameContext& frame, RowView& row) const override {
    add_to_row(row, static_cast<float>(frame(level_)));
  }

 private:
  Varying level_;
};

}  // namespace

EffectKind effect_black_level() {
  return effect_kind<BlackLevel>("black-level", 70,
                                 en::say("The sensor adds a constant to every pixel"), "level: 4");
}

}  // namespace alltact
