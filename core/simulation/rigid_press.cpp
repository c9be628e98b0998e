#include "core/simulation/rigid_press.h"

#include <numbers>

namespace alltact {
namespace {

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

}  // namespace

RigidPress::RigidPress(YamlSection& section, std::shared_ptr<const Body> (*read_body)(YamlSection&))
    : depth_(Varying::read(section, "depth_mm", strength_up_to(20))),
      s_(Varying::read(section, "s_mm", {-1000, 1000})),
      y_(Varying::read(section, "y_mm", {-1000, 1000})),
      rotation_deg_(Varying::read_or(section, "rotation_deg", 0, {-360, 360})),
      tilt_deg_(Varying::read_or(section, "tilt_deg", 0, {-45, 45})),
      roll_deg_(Varying::read_or(section, "roll_deg", 0, {-45, 45})),
      tip_deflection_(section),
      body_(read_body(section)) {}

Status RigidPress::validate(const SceneFacts& scene) const {
  if (const Status status = check_press(scene, depth_, s_, y_); !status) return status;
  return tip_deflection_.validate(scene);
}

void RigidPress::shape(const FrameContext& frame, FaceCurve& curve) const {
  tip_deflection_.shape(frame, s_, curve);
}

void RigidPress::apply(const FrameContext& frame, FrameGeometry& geometry) const {
  BodyPress press;
  press.pose = geometry.press_pose(frame(s_), frame(y_), frame(depth_));
  press.body = body_;
  press.rotation_rad = radians(frame(rotation_deg_));
  const PressPose& at = press.pose;
  Eigen::Matrix3d camera_from_face;
  camera_from_face << at.along, at.across, at.normal;
  const Eigen::Matrix3d turned =
      (Eigen::AngleAxisd(press.rotation_rad, Eigen::Vector3d::UnitZ()) *
       Eigen::AngleAxisd(radians(-frame(tilt_deg_)), Eigen::Vector3d::UnitY()) *
       Eigen::AngleAxisd(radians(frame(roll_deg_)), Eigen::Vector3d::UnitX()))
          .toRotationMatrix();
  press.camera_from_object = Eigen::Isometry3d::Identity();
  press.camera_from_object.linear() = camera_from_face * turned;
  const double lowest = body_->min_along_mm(turned.row(2).transpose());
  press.camera_from_object.translation() =
      at.luf_mm - Eigen::Vector3d(0, 0, at.depth_mm) - lowest * at.normal;
  press.posed = body_->posed(press.camera_from_object);

  ContactTruth truth = contact_truth(at);
  truth.camera_from_object = press.camera_from_object;
  truth.angle_deg = frame(rotation_deg_);
  geometry.contacts.push_back(std::move(truth));
  geometry.presses.emplace_back(std::move(press));
}

TipDeflection::TipDeflection(YamlSection& section) {
  if (section.has("give_mm"))
    deflection_mm_ = Varying::read(section, "give_mm", strength_up_to(100));
}

Status TipDeflection::validate(const SceneFacts& scene) const {
  if (deflection_mm_ && scene.finger.face.kind == FaceKind::kFlat)
    return Error{en::say("a flat sensor does not yield"), "", en::say("leave give_mm out")};
  return {};
}

void TipDeflection::shape(const FrameContext& frame, const Varying& s_mm, FaceCurve& curve) const {
  if (!deflection_mm_) return;
  // Modes t^2 and t^3 - t^2. K is the integral of the products of their second derivatives, (4 2; 2
  // 4), so q is along (4 p1 - 2 p2, 4 p2 - 2 p1) with p the modes at the press. Only the first mode
  // moves the tip.
  const double t = frame(s_mm) / curve.length_mm();
  const double p1 = t * t, p2 = t * t * (t - 1.0);
  const double q1 = -frame(*deflection_mm_);
  curve.bend(q1, q1 * (4.0 * p2 - 2.0 * p1) / (4.0 * p1 - 2.0 * p2));
}

}  // namespace alltact
