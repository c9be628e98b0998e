// Exposure that is not locked: I = G I with G = (target / mean(I))^share, limited to the given
// range. A settled control brings the image's mean to `target` grey levels (share 1), or a fraction
// of that correction. Each frame is controlled on its own, from its own light.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class AutomaticExposure final : public SensorEffect {
 public:
  explicit AutomaticExposure(YamlSection& p)
      : target_(p.number("target", {1, 255})),
        share_(p.number_or("share", 1, strength_up_to(1))),
        min_gain_(p.number_or("least", 0.1, {1e-3, 1})),
        max_gain_(p.number_or("greatest", 10, {1, 1000})) {
    if (min_gain_ == 1 && max_gain_ == 1)
      p.refuse("greatest", en::say("the exposure could not change"), en::say("more than 1"));
  }

  bool needs_full_image() const override { return true; }
  void process_image(const FrameContext&, const FrameGeometry&,
                     cv::Mat_<float>& grey) const override {
    const double mean = std::max(1e-6, cv::mean(grey)[0]);
    const double gain = std::clamp(std::pow(target_ / mean, share_), min_gain_, max_gain_);
    for (int v = 0; v < grey.rows; ++v) {
      float* value = grey[v];
      for (int u = 0; u < grey.cols; ++u) value[u] *= static_cast<float>(gain);
    }
  }

 private:
  double target_, share_, min_gain_, max_gain_;
};

}  // namespace

EffectKind effect_automatic_exposure() {
  return effect_kind<AutomaticExposure>(
      "automatic-exposure", 40, en::say("The camera adapts its exposure to the image brightness"),
      "target: 60");
}

}  // namespace alltact
