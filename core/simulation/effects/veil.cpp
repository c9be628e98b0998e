// Veiling glare: the lens scatters a share g of all light evenly over the image, I = (1 - g) I + g
// mean(I), g the veiling glare index of ISO 9358.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Veil final : public SensorEffect {
 public:
  explicit Veil(YamlSection& p) : share_(p.number("share", {0, 1, true, true, true})) {}

  bool needs_full_image() const override { return true; }
  void process_image(const FrameContext&, const FrameGeometry&,
                     cv::Mat_<float>& grey) const override {
    const auto veil = static_cast<float>(share_ * cv::mean(grey)[0]);
    const auto rest = static_cast<float>(1 - share_);
    for (int v = 0; v < grey.rows; ++v) {
      float* value = grey[v];
      for (int u = 0; u < grey.cols; ++u) value[u] = rest * value[u] + veil;
    }
  }

 private:
  double share_;
};

}  // namespace

EffectKind effect_veil() {
  return effect_kind<Veil>("veil", 15, en::say("Part of the light spreads over the entire image"),
                           "share: 0.02");
}

}  // namespace alltact
