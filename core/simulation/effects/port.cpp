// The camera looks into the silicone through a flat plate perpendicular to its axis. Rays refract
// at both of its sides by Snell's law and no longer start in one point (camera.h).
#include "core/simulation/effect.h"

namespace alltact {

namespace {

class Port final : public GeometryEffect {
 public:
  explicit Port(YamlSection& p)
      : port_{p.number("gap_mm", {0, 1000}), p.number("plate_mm", {0, 1000}),
              p.number_or("plate_index", 1.49, {1, 3}), p.number_or("medium_index", 1.41, {1, 3})} {
  }

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{en::say("a window does not bend parallel rays"), "", en::say("leave port out")};
    return {};
  }
  bool changes_lens() const override { return true; }
  void change_lens(CameraParameters& camera) const override { camera.port = port_; }

 private:
  FlatPort port_;
};

}  // namespace

EffectKind effect_port() {
  return effect_kind<Port>("port", 2,
                           en::say("The camera looks through a flat window into the silicone"),
                           "gap_mm: 2, plate_mm: 3");
}

}  // namespace alltact
