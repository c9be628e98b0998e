#include "core/gripper/gripper.h"

#include "core/finger/finger.h"
#include "core/finger/pose_yaml.h"
#include "core/printable.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace alltact {
namespace {

std::optional<Error> motor_problem(const GripperMotor& motor) {
  const auto is_position = [](double turns) { return std::abs(turns) <= 1e6; };
  if (!is_position(motor.first_turns) || !is_position(motor.last_turns) ||
      !(motor.first_turns < motor.last_turns))
    return Error{en::say("must be two motor positions, the lower one first"),
                 std::string("motor.range_turns"),
                 en::say("for example [0.0, 12.5]")};
  if (!(motor.sd_turns >= 0 && motor.sd_turns <= 1000))
    return Error{en::say("must be from 0 to 1000"),
                 std::string("motor.sd_turns"),
                 en::say("how far a motor position may be off, with the screw's play")};
  return std::nullopt;
}

bool is_name(const std::string& text) {
  return !text.empty() && text.size() <= 200;
}

}  // namespace

RigidTransform gripper_from_link(const LinkageParameters& linkage, double angle_rad) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY())),
          {linkage.pivot_mm.x(), 0.0, linkage.pivot_mm.y()}};
}

std::optional<Error> Gripper::finger_problem(std::size_t number) const {
  const GripperFinger& finger = fingers[number];
  const std::string key = fmt::format("fingers[{}]", number);
  if (!is_name(finger.name))
    return Error{en::say("must be a text of 1 to 200 letters"),
                 key + ".name",
                 en::say("what is written on the finger")};
  if (finger.folder.empty() || finger.folder.find('\0') != std::string::npos)
    return Error{en::say("must name the finger's folder"),
                 key + ".folder",
                 en::say("its path from the folder of this file, for example ../left-07")};
  const auto linkage = Linkage::create(finger.linkage, motor.lead_mm);
  if (!linkage) {
    const std::string part = linkage.error().where.english();
    return Error{linkage.error().what,
                 part == "lead_mm" ? "motor." + part : key + "." + part,
                 linkage.error().advice};
  }
  const MotorReach reach = linkage->reach_around(0.5 * (motor.first_turns + motor.last_turns));
  for (const auto& [end, is_beyond] :
       {std::pair(reach.first, motor.first_turns <= reach.first.motor_turns),
        std::pair(reach.last, motor.last_turns >= reach.last.motor_turns)})
    if (is_beyond)
      return Error{
          en::say("goes beyond what the finger {} can reach: at {:.6g} turns {}",
                  printable(finger.name),
                  end.motor_turns,
                  to_message(end.kind)),
          std::string("motor.range_turns"),
          en::say(
              "a range within {:.6g} to {:.6g}", reach.first.motor_turns, reach.last.motor_turns)};
  if (finger.link_from_camera.has_value() == finger.known_at_turns.has_value())
    return Error{en::say("must say where the camera sits in one way"),
                 key + ".link_from_camera",
                 en::say("this, or known_at_turns: the motor position at which gripper_from_camera "
                         "in the finger's own file holds")};
  if (finger.link_from_camera)
    return pose_problem(*finger.link_from_camera, key + ".link_from_camera");
  if (!(*finger.known_at_turns >= motor.first_turns && *finger.known_at_turns <= motor.last_turns))
    return Error{
        en::say("must lie in the motor's range"),
        key + ".known_at_turns",
        en::say("a motor position from {:g} to {:g}", motor.first_turns, motor.last_turns)};
  return std::nullopt;
}

Status Gripper::validate() const {
  if (!is_name(name))
    return Error{en::say("must be a text of 1 to 200 letters"),
                 std::string("name"),
                 en::say("what is written on the gripper")};
  if (auto problem = motor_problem(motor)) return *problem;
  for (std::size_t i = 0; i < fingers.size(); ++i)
    if (auto problem = finger_problem(i)) return *problem;
  if (fingers[0].name == fingers[1].name)
    return Error{en::say("is the name of the other finger too"),
                 std::string("fingers[1].name"),
                 en::say("two names, for example left and right")};
  return {};
}

Status Gripper::resolve_camera_poses(const std::filesystem::path& folder) {
  for (GripperFinger& finger : fingers) {
    if (!finger.known_at_turns) continue;
    const std::filesystem::path at = folder / finger.folder;
    const auto known = Finger::load(at);
    if (!known) return known.error();
    if (!known->gripper_from_camera)
      return Error{en::say("does not say where the camera sits in the gripper"),
                   at / Finger::kFileName,
                   en::say("add gripper_from_camera there, as it is at {:g} turns of the motor",
                           *finger.known_at_turns)};
    const auto linkage = Linkage::create(finger.linkage, motor.lead_mm);
    if (!linkage) return linkage.error();
    const auto angle = linkage->angle_at(*finger.known_at_turns);
    if (!angle) return angle.error();
    finger.link_from_camera =
        gripper_from_link(finger.linkage, angle->rad).inverse() * *known->gripper_from_camera;
    finger.known_at_turns.reset();
  }
  return {};
}

Result<GripperPose> Gripper::pose_at(double motor_turns, std::optional<double> sd_turns) const {
  const double slack = 1e-6 * (motor.last_turns - motor.first_turns);
  if (!(motor_turns >= motor.first_turns - slack && motor_turns <= motor.last_turns + slack))
    return Error{
        en::say("the motor cannot stand at {:.6g} turns: its range is from {:.6g} to {:.6g}",
                motor_turns,
                motor.first_turns,
                motor.last_turns),
        name,
        en::say("a motor position in that range, or correct range_turns")};
  GripperPose pose{motor_turns, sd_turns.value_or(motor.sd_turns), {}};
  if (!(pose.sd_turns >= 0 && std::isfinite(pose.sd_turns)))
    return Error{en::say("the standard deviation of a motor position must be 0 or above"),
                 name,
                 en::say("a number of turns")};
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const GripperFinger& finger = fingers[i];
    if (!finger.link_from_camera)
      return Error{
          en::say("it is not known where the camera of finger {} sits", printable(finger.name)),
          name,
          ""};
    const auto linkage = Linkage::create(finger.linkage, motor.lead_mm);
    if (!linkage) return linkage.error();
    const auto angle = linkage->angle_at(motor_turns);
    if (!angle) return Error{angle.error().what, finger.name, angle.error().advice};
    const RigidTransform link = gripper_from_link(finger.linkage, angle->rad);
    FingerPose& finger_pose = pose.fingers[i];
    finger_pose = {link * *finger.link_from_camera, *angle, {}, link.translation_mm};
    const double sd_rad = std::abs(angle->rad_per_turn) * pose.sd_turns;
    if (std::isfinite(sd_rad)) finger_pose.angle_sd_rad = sd_rad;
  }
  return pose;
}

std::vector<DeadPoint> Gripper::dead_points_in_range(std::size_t finger) const {
  std::vector<DeadPoint> within;
  const auto linkage = Linkage::create(fingers.at(finger).linkage, motor.lead_mm);
  if (!linkage) return within;
  for (const DeadPoint& point : linkage->dead_points())
    if (point.motor_turns >= motor.first_turns && point.motor_turns <= motor.last_turns)
      within.push_back(point);
  return within;
}

}  // namespace alltact
