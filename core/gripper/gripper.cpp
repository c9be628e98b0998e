#include "core/gripper/gripper.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/finger/finger.h"
#include "core/finger/finger_yaml.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

#include <fmt/format.h>

namespace alltact {
namespace {

std::optional<Error> motor_problem(const GripperMotor& motor) {
  const auto is_position = [](double turns) { return std::abs(turns) <= 1e6; };
  if (!is_position(motor.first_turns) || !is_position(motor.last_turns) ||
      !(motor.first_turns < motor.last_turns))
    return Error{en::say("must be two motor positions, the lower one first"),
                 std::string("motor.range_turns"), en::say("for example [0.0, 12.5]")};
  if (!(motor.sd_turns >= 0 && motor.sd_turns <= 1000))
    return Error{en::say("must be from 0 to 1000"), std::string("motor.sd_turns"),
                 en::say("the error of a motor position, with the screw's play")};
  return std::nullopt;
}

bool is_name(const std::string& text) { return !text.empty() && text.size() <= 200; }

}  // namespace

RigidTransform gripper_from_link(const LinkageParameters& linkage, double angle_rad) {
  return {Eigen::Quaterniond(Eigen::AngleAxisd(angle_rad, Eigen::Vector3d::UnitY())),
          {linkage.pivot_mm.x(), 0.0, linkage.pivot_mm.y()}};
}

std::optional<Error> Gripper::finger_problem(std::size_t number) const {
  const GripperFinger& finger = fingers[number];
  const std::string key = fmt::format("fingers[{}]", number);
  if (!is_name(finger.name))
    return Error{en::say("must be a text of 1 to 200 characters"), key + ".name",
                 en::say("what is written on the finger")};
  if (finger.folder.empty() || finger.folder.find('\0') != std::string::npos)
    return Error{en::say("must name the finger's folder"), key + ".folder",
                 en::say("its path from the folder of this file, for example ../left-07")};
  const auto linkage = Linkage::create(finger.linkage, motor.lead_mm);
  if (!linkage) {
    const std::string part = linkage.error().where.english();
    return Error{linkage.error().what, part == "lead_mm" ? "motor." + part : key + "." + part,
                 linkage.error().advice};
  }
  const MotorReach reach = linkage->reach_around(0.5 * (motor.first_turns + motor.last_turns));
  for (const auto& [end, is_beyond] :
       {std::pair(reach.first, motor.first_turns <= reach.first.motor_turns),
        std::pair(reach.last, motor.last_turns >= reach.last.motor_turns)})
    if (is_beyond)
      return Error{en::say("goes beyond what the finger {} can reach: at {:.6g} turns {}",
                           printable(finger.name), end.motor_turns, to_message(end.kind)),
                   std::string("motor.range_turns"),
                   en::say("a range within {:.6g} to {:.6g}", reach.first.motor_turns,
                           reach.last.motor_turns)};
  if (finger.link_from_camera.has_value() == finger.known_at_turns.has_value())
    return Error{en::say("must specify the camera's pose exactly once"), key + ".link_from_camera",
                 en::say("this, or known_at_turns: the motor position at which gripper_from_camera "
                         "in the finger's own file holds")};
  if (finger.link_from_camera)
    return pose_problem(*finger.link_from_camera, key + ".link_from_camera");
  if (!(*finger.known_at_turns >= motor.first_turns && *finger.known_at_turns <= motor.last_turns))
    return Error{
        en::say("must lie in the motor's range"), key + ".known_at_turns",
        en::say("a motor position from {:g} to {:g}", motor.first_turns, motor.last_turns)};
  return std::nullopt;
}

Status Gripper::validate() const {
  if (!is_name(name))
    return Error{en::say("must be a text of 1 to 200 characters"), std::string("name"),
                 en::say("the name on the gripper")};
  if (auto problem = motor_problem(motor)) return *problem;
  for (std::size_t i = 0; i < fingers.size(); ++i)
    if (auto problem = finger_problem(i)) return *problem;
  if (fingers[0].name == fingers[1].name)
    return Error{en::say("is also the name of the other finger"), std::string("fingers[1].name"),
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
      return Error{en::say("does not specify the camera's pose in the gripper"),
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
                motor_turns, motor.first_turns, motor.last_turns),
        name, en::say("a motor position in that range, or correct range_turns")};
  GripperPose pose{motor_turns, sd_turns.value_or(motor.sd_turns), {}};
  if (!(pose.sd_turns >= 0 && std::isfinite(pose.sd_turns)))
    return Error{en::say("the standard deviation of a motor position must be 0 or above"), name,
                 en::say("a number of turns")};
  for (std::size_t i = 0; i < fingers.size(); ++i) {
    const GripperFinger& finger = fingers[i];
    if (!finger.link_from_camera)
      return Error{en::say("the camera pose of finger {} is unknown", printable(finger.name)), name,
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

namespace {

constexpr double kMaxLength_mm = 1e4;
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

/// sqrt(a^2 - b^2), by factors so that nothing cancels; nullopt where b is larger.
std::optional<double> other_side(double a, double b) {
  const double square = (a - b) * (a + b);
  if (square < 0) return std::nullopt;
  return std::sqrt(square);
}

double to_one_turn(double rad) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (rad > std::numbers::pi) return rad - kTurn;
  return rad <= -std::numbers::pi ? rad + kTurn : rad;
}

/// The angle of a triangle between the sides `c` and `d`, opposite `r`, as half-angle sine and
/// cosine times a common factor. nullopt: the sides form no triangle.
std::optional<Eigen::Vector2d> half_angle(double c, double d, double r) {
  double across = ((r - d) + c) * (r + (d - c));
  double along = ((d - r) + c) * (d + (c + r));
  // In a dead point rounding must not open the loop.
  const double lower_limit = -kRounding * (c + d + r) * (c + d + r);
  if (across < lower_limit || along < lower_limit) return std::nullopt;
  across = std::max(0.0, across), along = std::max(0.0, along);
  if (!(across + along > 0)) return std::nullopt;
  return Eigen::Vector2d(std::sqrt(across), std::sqrt(along));
}

Error bad_length(const char* key, Message advice) {
  return {en::say("must be above 0 and at most {:g}", kMaxLength_mm), std::string(key), advice};
}

}  // namespace

Message to_message(DeadPointKind kind) {
  switch (kind) {
    case DeadPointKind::kStretched:
      return en::say("rod and crank are stretched into one line");
    case DeadPointKind::kFolded:
      return en::say("rod and crank are folded into one line");
    case DeadPointKind::kAcross:
      return en::say("the rod lies across the screw");
  }
  return {};
}

Result<Linkage> Linkage::create(const LinkageParameters& p, double lead_mm) {
  const auto is_point = [](const Eigen::Vector2d& at) {
    return at.allFinite() && at.cwiseAbs().maxCoeff() <= kMaxLength_mm;
  };
  if (!(std::abs(lead_mm) >= 1e-6 && std::abs(lead_mm) <= kMaxLength_mm))
    return Error{en::say("must be a travel in mm, above or below 0"), std::string("lead_mm"),
                 en::say("how far the nut goes away from the palm in one turn, for example 2.0")};
  if (!is_point(p.pivot_mm))
    return Error{en::say("must be numbers from -{0:g} to {0:g}", kMaxLength_mm),
                 std::string("pivot_mm"),
                 en::say("x and z of the axis that the finger turns about, in mm")};
  if (!is_point(p.nut_mm))
    return Error{en::say("must be numbers from -{0:g} to {0:g}", kMaxLength_mm),
                 std::string("nut_mm"),
                 en::say("x and z of the rod's joint on the nut at motor position 0, in mm")};
  if (!(p.crank_mm > 0 && p.crank_mm <= kMaxLength_mm))
    return bad_length("crank_mm", en::say("the distance from the finger's axis to the rod, in mm"));
  if (!(p.rod_mm > 0 && p.rod_mm <= kMaxLength_mm))
    return bad_length("rod_mm", en::say("the distance between the rod's joints, in mm"));
  const double offset = std::abs(p.nut_mm.x() - p.pivot_mm.x());
  if (offset >= p.crank_mm + p.rod_mm)
    return Error{en::say("rod and crank never meet: together they reach {:g} mm, and the nut "
                         "passes the finger's axis at {:g} mm",
                         p.crank_mm + p.rod_mm, offset),
                 std::string("rod_mm"),
                 en::say("measure pivot_mm, nut_mm, crank_mm and rod_mm again")};
  return Linkage(p, lead_mm);
}

double Linkage::turns_at_height(double above_pivot_mm) const {
  return (parameters_.pivot_mm.y() + above_pivot_mm - parameters_.nut_mm.y()) / lead_mm_;
}

Result<LinkageAngle> Linkage::angle_at(double motor_turns) const {
  const LinkageParameters& p = parameters_;
  if (!std::isfinite(motor_turns))
    return Error{en::say("the motor position is not a number"), "", en::say("a number of turns")};
  const double x = p.nut_mm.x() - p.pivot_mm.x();
  const double z = std::fma(lead_mm_, motor_turns, p.nut_mm.y() - p.pivot_mm.y());
  const double d = std::hypot(x, z), c = p.crank_mm, r = p.rod_mm;
  if (!(d > 0))
    return Error{en::say("at {:.6g} turns the rod's joint lies on the finger's axis, so that the "
                         "finger may stand anywhere",
                         motor_turns),
                 "", en::say("another motor position")};
  const auto half = half_angle(c, d, r);
  if (!half) {
    const MotorReach reach = reach_around(motor_turns);
    return Error{en::say("rod and crank do not meet at {:.6g} turns: they do from {:.6g} ({}) to "
                         "{:.6g} ({})",
                         motor_turns, reach.first.motor_turns, to_message(reach.first.kind),
                         reach.last.motor_turns, to_message(reach.last.kind)),
                 "", en::say("a motor position between these")};
  }
  const double side = p.assembly == AssemblyMode::kAhead ? 1.0 : -1.0;
  const double angle = std::atan2(x, z) + side * 2.0 * std::atan2(half->x(), half->y());
  const double sine = 2.0 * half->x() * half->y() / half->squaredNorm();
  const double rod_z = z - c * std::cos(angle);
  // Rod and crank in line across the screw: the finger may continue in either direction.
  const double rate = sine == 0 && rod_z == 0 ? std::numeric_limits<double>::infinity()
                                              : -side * lead_mm_ * rod_z / (c * d * sine);
  return LinkageAngle{to_one_turn(angle), rate};
}

std::vector<MotorReach> Linkage::intervals() const {
  using Kind = DeadPointKind;
  const LinkageParameters& p = parameters_;
  const double x = std::abs(p.nut_mm.x() - p.pivot_mm.x());
  const double far = *other_side(p.crank_mm + p.rod_mm, x);
  const auto interval = [&](double low, Kind low_kind, double high, Kind high_kind) {
    MotorReach reach{{low_kind, turns_at_height(low)}, {high_kind, turns_at_height(high)}};
    if (lead_mm_ < 0) std::swap(reach.first, reach.last);
    return reach;
  };
  const auto near = other_side(std::abs(p.crank_mm - p.rod_mm), x);
  if (!near) return {interval(-far, Kind::kStretched, far, Kind::kStretched)};
  std::vector<MotorReach> intervals{interval(-far, Kind::kStretched, -*near, Kind::kFolded),
                                    interval(*near, Kind::kFolded, far, Kind::kStretched)};
  if (lead_mm_ < 0) std::swap(intervals[0], intervals[1]);
  return intervals;
}

MotorReach Linkage::reach_around(double motor_turns) const {
  const std::vector<MotorReach> all = intervals();
  const auto away = [&](const MotorReach& interval) {
    return std::max(
        {0.0, interval.first.motor_turns - motor_turns, motor_turns - interval.last.motor_turns});
  };
  return *std::min_element(all.begin(), all.end(),
                           [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

std::vector<DeadPoint> Linkage::dead_points() const {
  const LinkageParameters& p = parameters_;
  std::vector<DeadPoint> points;
  for (const MotorReach& interval : intervals())
    points.insert(points.end(), {interval.first, interval.last});
  const double x = p.nut_mm.x() - p.pivot_mm.x();
  const double side = p.assembly == AssemblyMode::kAhead ? 1.0 : -1.0;
  for (const double rod : {p.rod_mm, -p.rod_mm}) {
    // The pin is at the nut's height h above the pivot, at the lateral offset x + rod.
    const auto height = other_side(p.crank_mm, std::abs(x + rod));
    if (!height) continue;
    for (const double h : {*height, -*height}) {
      // On the side of the line to the nut that the assembly mode requires: sin(t - l) has the sign
      // of (x + rod) h - h x.
      if (side * rod * h > 0) points.push_back({DeadPointKind::kAcross, turns_at_height(h)});
    }
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const auto& a, const auto& b) { return a.motor_turns < b.motor_turns; });
  return points;
}

// Reads and writes gripper.yaml.

struct Gripper::Unknown {
  UnknownKeys keys;
};

static void describe(Fields& fields, GripperMotor& motor) {
  fields.number("lead_mm", motor.lead_mm, en::say("a travel in mm for each turn"));
  fields.numbers("range_turns", {&motor.first_turns, &motor.last_turns},
                 en::say("must be two motor positions, the lower one first"),
                 en::say("for example [0.0, 12.5]"));
  fields.number(may("sd_turns"), motor.sd_turns, {0.0, 1000.0});
}

static void describe(Fields& fields, GripperFinger& finger) {
  static const EnumWords kAssemblies{"ahead", "behind"};
  const Message refusal = en::say("must be two numbers: x and z in mm");
  LinkageParameters& linkage = finger.linkage;
  fields.text("name", finger.name);
  fields.text("folder", finger.folder);
  fields.numbers("pivot_mm", {&linkage.pivot_mm.x(), &linkage.pivot_mm.y()}, refusal);
  fields.numbers("nut_mm", {&linkage.nut_mm.x(), &linkage.nut_mm.y()}, refusal);
  fields.number("crank_mm", linkage.crank_mm, en::say("a length in mm"));
  fields.number("rod_mm", linkage.rod_mm, en::say("a length in mm"));
  fields.choice("assembly", linkage.assembly, kAssemblies);
  if (fields.has(may("known_at_turns"), finger.known_at_turns))
    fields.number("known_at_turns", *finger.known_at_turns, en::say("a motor position"));
  fields.section(may("link_from_camera").required_if(!finger.known_at_turns),
                 finger.link_from_camera);
}

static void describe(Fields& fields, Gripper& gripper) {
  fields.format(Gripper::kFormat,
                en::say("a newer version of this program, or '{}'", std::string(Gripper::kFormat)));
  fields.text("name", gripper.name);
  fields.section("motor", gripper.motor, Fields::Layout::kLines);
  auto& fingers = gripper.fingers;
  const auto check = [&](std::size_t count) {
    fields.demand(count == fingers.size(), "fingers", en::say("must be two fingers, not {}", count),
                  en::say("one block '- name: ...' for each"));
  };
  fields.sections("fingers", Fields::Layout::kLines, fingers.size(), check,
                  [&](Fields& finger, std::size_t i) { describe(finger, fingers[i]); });
}

Result<Gripper> Gripper::parse(const std::string& yaml, const std::filesystem::path& origin,
                               std::vector<Message>* warnings) {
  YamlFile file(origin);
  auto gripper = read_fields<Gripper>(file, yaml);
  if (!gripper) return gripper;
  if (const Status status = gripper->validate(); !status) return file.located(status.error());
  gripper->unknown_ = std::make_shared<const Unknown>(Unknown{std::move(file.unknown())});
  if (warnings != nullptr) *warnings = std::move(file.warnings());
  return gripper;
}

Result<Gripper> Gripper::load(const std::filesystem::path& path, std::vector<Message>* warnings) {
  std::error_code ignored;
  const bool is_folder = std::filesystem::is_directory(path, ignored);
  const std::filesystem::path file = is_folder ? path / kFileName : path;
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  auto gripper = parse(*content, file, warnings);
  if (!gripper) return gripper;
  if (const Status taken = gripper->resolve_camera_poses(file.parent_path()); !taken)
    return taken.error();
  return gripper;
}

Result<std::string> Gripper::to_yaml() const {
  static const UnknownKeys kNone;
  if (const Status status = validate(); !status) return status.error();
  return fields_text(*this, unknown_ ? unknown_->keys : kNone);
}

Status Gripper::save(const std::filesystem::path& file) const {
  const auto text = to_yaml();
  if (!text) return text.error();
  return write_file_atomically(file, *text);
}

}  // namespace alltact
