// Folds of the side faces hide dots: the same ones in every frame (`markers`), or `count` of them
// drawn anew for each frame.
#include "core/numerics/philox.h"
#include "core/simulation/effect.h"

#include <numeric>

namespace alltact {

namespace {

class Occlusion final : public GeometryEffect {
 public:
  explicit Occlusion(YamlSection& p) : by_count_(p.has("count")) {
    if (by_count_) {
      count_ = Varying::read(p, "count", {0, 128});
      if (count_.max_value() < 0.5)
        p.refuse("count", en::say("no dot would ever be hidden"),
                 en::say("leave occlusion out, or use 1 or more"));
      return;
    }
    markers_ = read_marker_numbers(p);
  }

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("markers"))
      return Error{en::say("there are no dots to hide"), "", en::say("add the effect markers")};
    const auto n = static_cast<std::size_t>(scene.finger.marker_count());
    for (const std::size_t number : markers_)
      if (number >= n)
        return Error{en::say("there is no marker {}", number), "", en::say("0 to {}", n - 1)};
    if (count_.max_value() > static_cast<double>(n))
      return Error{en::say("more dots would be hidden than there are"), "", en::say("up to {}", n)};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    for (const std::size_t number : by_count_ ? drawn(frame, geometry.discs.size()) : markers_)
      geometry.discs[number].visible = false;
  }

 private:
  // The first `count` entries of a shuffled list of numbers.
  std::vector<std::size_t> drawn(const FrameContext& frame, std::size_t n) const {
    std::vector<std::size_t> numbers(n);
    std::iota(numbers.begin(), numbers.end(), 0U);
    const auto count = std::min(n, static_cast<std::size_t>(std::lround(frame(count_))));
    for (std::size_t i = 0; i < count; ++i) {
      const double unit =
          philox_uniform(frame.seed, "occlusion.which", static_cast<std::uint32_t>(frame.frame),
                         static_cast<std::uint32_t>(i));
      std::swap(numbers[i],
                numbers[i + static_cast<std::size_t>(unit * static_cast<double>(n - i))]);
    }
    numbers.resize(count);
    return numbers;
  }

  bool by_count_;
  Varying count_;
  std::vector<std::size_t> markers_;
};

}  // namespace

EffectKind effect_occlusion() {
  return effect_kind<Occlusion>("occlusion", 61, en::say("Folds of the side faces hide dots"),
                                "count: 3", {"sides", "markers"});
}

}  // namespace alltact
