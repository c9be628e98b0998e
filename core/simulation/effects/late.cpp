// Frames arrive `by_ms` milliseconds late, each with the probability `share`. Their capture times
// do not change. Only visible at the camera's pace.
#include "core/numerics/philox.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Late final : public TransportEffect {
 public:
  explicit Late(YamlSection& p)
      : share_(p.number("share", strength_up_to(1))),
        by_ms_(Varying::read(p, "by_ms", strength_up_to(60000))) {}

  bool is_repeatable() const override { return true; }

  void arrival(const FrameContext& frame, Arrival& arrival) const override {
    const auto number = static_cast<std::uint32_t>(frame.frame);
    if (philox_uniform(frame.seed, "late", number, 0) < share_) arrival.late_ms += frame(by_ms_);
  }

 private:
  double share_;
  Varying by_ms_;
};

}  // namespace

EffectKind effect_late() {
  return effect_kind<Late>("late", 70, en::say("Frames arrive late"), "share: 0.1, by_ms: 40");
}

}  // namespace alltact
