// Frames are lost in transport: each with probability `share`, together with the `run` - 1 frames
// behind it, as when a bus is busy for a while.
#include "core/numerics/philox.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Drop final : public TransportEffect {
 public:
  explicit Drop(YamlSection& p)
      : share_(p.number("share", {0, 1, true, true, true})),
        run_(p.integer_or("run", 1, 1, 1000)) {}

  bool is_repeatable() const override { return true; }

  void arrival(const FrameContext& frame, Arrival& arrival) const override {
    for (int first = std::max(0, frame.frame - run_ + 1); first <= frame.frame; ++first)
      if (philox_uniform(frame.seed, "drop", static_cast<std::uint32_t>(first), 0) < share_)
        arrival.is_dropped = true;
  }

 private:
  double share_;
  int run_;
};

}  // namespace

EffectKind effect_drop() {
  return effect_kind<Drop>("drop", 60, en::say("Frames are lost in transmission"), "share: 0.01");
}

}  // namespace alltact
