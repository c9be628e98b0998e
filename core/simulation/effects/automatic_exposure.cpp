// The camera's exposure is not locked: I = G I with G = (target / mean(I))^share, between `least`
// and `greatest`. A control that has settled brings the picture's mean to `target` grey levels
// (share 1) or part of the way there. Frame by frame on its own, from that frame's light.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class AutomaticExposure final : public SensorEffect {
 public:
  explicit AutomaticExposure(YamlSection& p)
      : target_(p.number("target", {1, 255})),
        share_(p.number_or("share", 1, strength_up_to(1))),
        least_(p.number_or("least", 0.1, {1e-3, 1})),
        greatest_(p.number_or("greatest", 10, {1, 1000})) {
    if (least_ == 1 && greatest_ == 1)
      p.refuse("greatest", en::say("the exposure could not change"), en::say("more than 1"));
  }

  Message sentence() const override {
    return en::say("The camera exposes by itself, by how bright the picture is");
  }

  bool needs_picture() const override { return true; }
  void picture(const FrameContext&, const FrameGeometry&, cv::Mat_<float>& grey) const override {
    const double mean = std::max(1e-6, cv::mean(grey)[0]);
    const double gain = std::clamp(std::pow(target_ / mean, share_), least_, greatest_);
    for (int v = 0; v < grey.rows; ++v) {
      float* value = grey[v];
      for (int u = 0; u < grey.cols; ++u) value[u] *= static_cast<float>(gain);
    }
  }

 private:
  double target_, share_, least_, greatest_;
};

}  // namespace

const EffectKind& effect_automatic_exposure() {
  static const EffectKind kKind{"automatic-exposure",
                                Stage::kSensor,
                                40,
                                [](YamlSection& p) -> std::shared_ptr<const Effect> {
                                  return std::make_shared<AutomaticExposure>(p);
                                },
                                "target: 60"};
  return kKind;
}

}  // namespace alltact
