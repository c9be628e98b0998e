// A ball presses into the face until its deepest point lies `depth_mm` along z.
#include "core/simulation/effect.h"
#include "core/simulation/rigid_press.h"

namespace alltact {

namespace {

class Ball final : public GeometryEffect {
 public:
  explicit Ball(YamlSection& p)
      : radius_(Varying::read(p, "radius_mm", strength_up_to(100))),
        depth_(Varying::read(p, "depth_mm", strength_up_to(20))),
        s_(Varying::read(p, "s_mm", {-1000, 1000})),
        y_(Varying::read(p, "y_mm", {-1000, 1000})),
        tip_deflection_(p) {}

  bool is_repeatable() const override { return true; }
  bool presses_ball() const override { return true; }

  Status validate(const SceneFacts& scene) const override {
    if (const Status status = check_press(scene, depth_, s_, y_); !status) return status;
    if (depth_.max_value() >= radius_.min_value())
      return Error{en::say("the ball would sink in past its centre"), "",
                   en::say("depth_mm below radius_mm")};
    return tip_deflection_.validate(scene);
  }

  void shape(const FrameContext& frame, FaceCurve& curve) const override {
    tip_deflection_.shape(frame, s_, curve);
  }

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    BallPress press =
        make_ball_press(geometry.press_pose(frame(s_), frame(y_), frame(depth_)), frame(radius_));
    ContactTruth truth = contact_truth(press.pose);
    truth.camera_from_object = Eigen::Isometry3d::Identity();
    truth.camera_from_object->translation() = press.centre_mm;
    geometry.contacts.push_back(std::move(truth));
    geometry.presses.emplace_back(std::move(press));
  }

 private:
  Varying radius_, depth_, s_, y_;
  TipDeflection tip_deflection_;
};

}  // namespace

EffectKind effect_ball() {
  return effect_kind<Ball>("ball", 30, en::say("A ball is pressed into the face"),
                           "radius_mm: 4, s_mm: 50, y_mm: 0, depth_mm: 0.9");
}

}  // namespace alltact
