// Dots that have lost part of their paint or depth: what is seen of them is side + (1 - wear) (dot
// - side), so a wear of 1 leaves nothing to see. Where they are stays true and visible, unlike what
// occlusion hides.
#include "core/simulation/effect.h"
#include "core/simulation/marker_numbers.h"

namespace alltact {

namespace {

class WornMarker final : public GeometryEffect {
 public:
  explicit WornMarker(YamlSection& p) : wear_(Varying::read(p, "wear", strength_up_to(1))) {
    markers_ = read_marker_numbers(p);
  }

  Message sentence() const override { return en::say("Dots are worn and fainter"); }
  bool may_be_several() const override { return true; }

  Status fits(const SceneFacts& scene) const override {
    if (!scene.names("markers"))
      return Error{
          en::say("there are no dots to wear off"), "", en::say("name the effect markers too")};
    const auto n = static_cast<std::size_t>(scene.finger.marker_count());
    for (const std::size_t number : markers_)
      if (number >= n)
        return Error{en::say("there is no marker {}", number), "", en::say("0 to {}", n - 1)};
    return {};
  }

  void place(const FrameContext& frame, FrameGeometry& geometry) const override {
    const double left = 1 - frame(wear_);
    for (const std::size_t number : markers_)
      if (MarkerDisc& disc = geometry.discs[number]; disc.visible)
        disc.coverage = cv::Mat_<float>(disc.coverage * left);
  }

 private:
  Varying wear_;
  std::vector<std::size_t> markers_;
};

}  // namespace

const EffectKind& effect_worn_marker() {
  static const EffectKind kKind{"worn-marker",
                                Stage::kGeometry,
                                62,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<WornMarker>(p);
                                },
                                "markers: [2], wear: 0.5",
                                {"sides", "markers"}};
  return kKind;
}

}  // namespace alltact
