// Dots that have lost paint or depth: side + (1 - fraction lost) (dot - side) remains visible. At a
// loss of 1 nothing remains. In the truth they stay visible, unlike dots under an occlusion.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class WornMarker final : public GeometryEffect {
 public:
  explicit WornMarker(YamlSection& p)
      : worn_fraction_(Varying::read(p, "wear", strength_up_to(1))) {
    markers_ = read_marker_numbers(p);
  }

  bool is_repeatable() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    if (!scene.has_effect("markers"))
      return Error{en::say("there are no dots to wear off"), "", en::say("add the effect markers")};
    const auto n = static_cast<std::size_t>(scene.finger.marker_count());
    for (const std::size_t number : markers_)
      if (number >= n)
        return Error{en::say("there is no marker {}", number), "", en::say("0 to {}", n - 1)};
    return {};
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    const double left = 1 - frame(worn_fraction_);
    for (const std::size_t number : markers_)
      if (MarkerDisc& disc = geometry.discs[number]; disc.visible)
        disc.coverage = cv::Mat_<float>(disc.coverage * left);
  }

 private:
  Varying worn_fraction_;
  std::vector<std::size_t> markers_;
};

}  // namespace

EffectKind effect_worn_marker() {
  return effect_kind<WornMarker>("worn-marker", 62, en::say("Dots are worn and fainter"),
                                 "markers: [2], wear: 0.5", {"sides", "markers"});
}

}  // namespace alltact
