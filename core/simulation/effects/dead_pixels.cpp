// Pixels that always give 0 (`dead`) or 255 (`hot`), the same in all frames: each pixel
// independently with that probability. The gap to the next one is floor(ln U / ln(1 - p)) pixels of
// its row, the geometric distribution. A row thus needs only one draw for each such pixel.
#include "core/numerics/philox.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

constexpr double kHotLevel = 255;

class DeadPixels final : public SensorEffect {
 public:
  explicit DeadPixels(YamlSection& p)
      : dead_(p.number_or("dead", 0, {0, 1, true, true, true})),
        hot_(p.number_or("hot", 0, {0, 1, true, true, true})) {
    if (dead_ == 0 && hot_ == 0)
      p.refuse("", en::say("there is neither dead nor hot"), en::say("name one of them"));
  }

  void row(const FrameContext& frame, RowView& row) const override {
    set(frame.seed, "dead-pixels.dead", dead_, 0, row);
    set(frame.seed, "dead-pixels.hot", hot_, kHotLevel, row);
  }

 private:
  static void set(std::uint64_t seed, std::string_view stream, double share, double level,
                  RowView& row) {
    if (share == 0) return;
    const double per_log = 1 / std::log1p(-share);
    double at = -1;
    for (std::uint32_t i = 0;; ++i) {
      const double unit = philox_uniform(seed, stream, static_cast<std::uint32_t>(row.v), i);
      at += 1 + std::floor(std::log(unit) * per_log);
      if (at >= row.width) return;
      row.value[static_cast<int>(at)] = static_cast<float>(level);
    }
  }

  double dead_, hot_;
};

}  // namespace

EffectKind effect_dead_pixels() {
  return effect_kind<DeadPixels>("dead-pixels", 75,
                                 en::say("Single pixels are always dark or always bright"),
                                 "dead: 0.0001, hot: 0.0001");
}

}  // namespace alltact
