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

  Message sentence() const override { return en::say("Frames are lost in transmission"); }
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

const EffectKind& effect_drop() {
  static const EffectKind kKind{
      "drop",
      Stage::kTransport,
      60,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Drop>(p); },
      "share: 0.01"};
  return kKind;
}

}  // namespace alltact
