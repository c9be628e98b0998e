// The lens distorts: Brown's k1 k2 p1 p2 k3 k4 k5 k6 s1 s2 s3 s4 for a pinhole or brown camera,
// Kannala's k1 k2 k3 k4 for a fisheye (camera.h). The scene is rendered along the bent rays;
// nothing is resampled.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Distortion final : public GeometryEffect {
 public:
  explicit Distortion(YamlSection& p)
      : coefficients_(p.numbers("coefficients", 1, 12, {-1e6, 1e6})) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{en::say("an orthographic camera has no lens"), "",
                   en::say("leave distortion out")};
    return {};
  }
  bool changes_lens() const override { return true; }
  void change_lens(CameraParameters& camera) const override {
    if (camera.model == CameraModel::kPinhole) camera.model = CameraModel::kBrown;
    camera.distortion = coefficients_;
  }

 private:
  std::vector<double> coefficients_;
};

}  // namespace

EffectKind effect_distortion() {
  return effect_kind<Distortion>("distortion", 1, en::say("The lens bends straight lines"),
                                 "coefficients: [-0.2, 0.05]");
}

}  // namespace alltact
