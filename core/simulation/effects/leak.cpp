// Stray light that reaches the sensor directly: I = I + b. Either `grey`, b in grey levels, or
// `lux` of the room and `grey_per_lux`, b = lux * grey_per_lux.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Leak final : public SensorEffect {
 public:
  explicit Leak(YamlSection& p)
      : per_unit_(p.has("lux") ? p.number("grey_per_lux", strength_up_to(100)) : 1),
        amount_(p.has("lux") ? Varying::read(p, "lux", strength_up_to(2e5))
                             : Varying::read(p, "grey", strength_up_to(255))) {}

  void row(const FrameContext& frame, RowView& row) const override {
    add_to_row(row, static_cast<float>(per_unit_ * frame(amount_)));
  }

 private:
  double per_unit_;
  Varying amount_;
};

}  // namespace

EffectKind effect_leak() {
  return effect_kind<Leak>("leak", 20, en::say("Stray light falls on the sensor"), "grey: 3");
}

}  // namespace alltact
