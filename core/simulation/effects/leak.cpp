// Stray light that reaches the sensor directly: I = I + b. Either `grey`, b in grey levels, or
// `lux` of the room and `grey_per_lux`, b = lux * grey_per_lux.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

ALLTACT_WIDE void add_leak(int n, float level, float* __restrict value) {
  for (int u = 0; u < n; ++u) value[u] += level;
}

class Leak final : public SensorEffect {
 public:
  explicit Leak(YamlSection& p)
      : per_unit_(p.has("lux") ? p.number("grey_per_lux", strength_up_to(100)) : 1),
        amount_(p.has("lux") ? Varying::read(p, "lux", strength_up_to(2e5))
                             : Varying::read(p, "grey", strength_up_to(255))) {}

  Message sentence() const override { return en::say("Stray light falls on the sensor"); }

  void row(const FrameContext& frame, RowView& row) const override {
    add_leak(row.width, static_cast<float>(per_unit_ * frame(amount_)), row.value);
  }

 private:
  double per_unit_;
  Varying amount_;
};

}  // namespace

const EffectKind& effect_leak() {
  static const EffectKind kKind{
      "leak",
      Stage::kSensor,
      20,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Leak>(p); },
      "grey: 3"};
  return kKind;
}

}  // namespace alltact
