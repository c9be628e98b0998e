// Gripper: two fingers, the screw that moves them, and the poses of their cameras for a motor
// position.
//
// FRAMES. The gripper's frame is fixed in its body: x is the direction in which the fingers close,
// y is parallel to their rotation axes, z runs along the screw away from the palm. A finger's link
// moves with its crank: origin on the finger's axis at y = 0, z along the crank, y as the
// gripper's. With the crank's angle t
//   gripper_from_link   = rotation by t about y, then shift to the pivot
//   gripper_from_camera = gripper_from_link * link_from_camera
//
//   const auto gripper = Gripper::load("gripper");           // gripper/gripper.yaml
//   const auto pose = gripper->pose_at(3.2);                 // turns
//   pose->fingers[0].gripper_from_camera.point(position_mm);    // finger 0's contact, in the
//   gripper
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/geometry/rigid_transform.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

// The rod and the crank that convert a screw's travel into the rotation of a finger: an offset
// slider-crank whose slider is the screw's nut.
//
//      z ^        C  crank pin             N = (nut_x, nut_z + lead m)   on the nut, at motor m
//        |       / \ .                     C = P + c (sin t, cos t)      carried by the finger
//        |      /    \  rod r              |N - C| = r                   the loop equation
//        |   c / t     \ .
//        |    /          N  nut            t: the crank's angle, from +z towards +x
//        |   P  pivot    |  slides along z
//        +---------------|-------> x
//
// Everything lies in the gripper's plane of x (the fingers close along it) and z (along the screw,
// away from the palm); the pivot's axis is y.
//
// CLOSED FORM. With D = N - P of length d and direction l, the law of cosines in the triangle of c,
// r and d gives the angle at P by its half, which loses no digits where the triangle is flat
// (W. Kahan, Miscalculating area and angles of a needle-like triangle, 2014):
//   t = l +- f,   tan(f/2) = sqrt( ((r - d) + c) (r + (d - c)) / (((d - r) + c) (d + (c + r))) )
// The sign is the assembly mode: the same parts fit together in two configurations.
//
// DERIVATIVE. From the loop equation, with C' = dC/dt:  (N - C).C' dt = (N - C).z ds, and
// (N - C).C' = -+ c d sin(f):
//   dt/dm = lead (N - C)_z / (-+ c d sin(f))
//
// DEAD POINTS (J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, on
// the slider-crank). Where rod and crank lie in one line, stretched (d = r + c) or folded
// (d = |r - c|), the loop closes no farther and dt/dm is infinite. Where the rod lies across the
// screw, dt/dm is 0: the finger stands still and reverses beyond.

/// The side of the line from pivot to nut on which the crank's pin lies.
enum class AssemblyMode {
  kAhead = 1,  ///< t = l + f: from the line towards +x, in the sense of t
  kBehind,     ///< t = l - f
};

struct LinkageParameters {
  Eigen::Vector2d pivot_mm = {0, 0};  ///< x, z in the gripper
  Eigen::Vector2d nut_mm = {0, 0};    ///< x, z of the rod's joint on the nut at motor position 0
  double crank_mm = 0;                ///< pivot to pin, above 0
  double rod_mm = 0;                  ///< pin to nut, above 0
  AssemblyMode assembly = AssemblyMode::kAhead;
};

enum class DeadPointKind {
  kStretched = 1,  ///< rod and crank in one line, one behind the other; dt/dm infinite
  kFolded,         ///< in one line, one upon the other; dt/dm infinite
  kAcross,         ///< the rod lies across the screw; dt/dm is 0
};
[[nodiscard]] Message to_message(DeadPointKind kind);

struct DeadPoint {
  DeadPointKind kind;
  double motor_turns;
};

/// The interval of motor positions in which the loop closes, ends included.
struct MotorReach {
  DeadPoint first, last;
};

struct LinkageAngle {
  double rad = 0;           ///< t, in (-pi, pi]
  double rad_per_turn = 0;  ///< dt/dm; infinite in dead points that end the reach
};

/// A value. Motor positions are in turns of the screw. A motor with other units needs its own lead
/// (1 for mm of travel).
class Linkage {
 public:
  /// lead_mm: travel of the nut along +z in one turn, not 0. Errors (`where` is the key): a number
  /// that is not finite or beyond 10000 mm; a length not above 0; parts that never join, since the
  /// nut passes the pivot beyond the reach of crank and rod.
  static Result<Linkage> create(const LinkageParameters& parameters, double lead_mm);

  /// Error: the loop does not close there, or nut and pivot coincide so that the crank's angle is
  /// undefined. The message gives the valid interval.
  [[nodiscard]] Result<LinkageAngle> angle_at(double motor_turns) const;

  /// All of them, ascending: 2 to 6.
  [[nodiscard]] std::vector<DeadPoint> dead_points() const;

  /// The closing interval nearest to a motor position, or the one that contains it.
  [[nodiscard]] MotorReach reach_around(double motor_turns) const;

  [[nodiscard]] const LinkageParameters& parameters() const { return parameters_; }
  [[nodiscard]] double lead_mm() const { return lead_mm_; }

 private:
  Linkage(const LinkageParameters& parameters, double lead_mm)
      : parameters_(parameters), lead_mm_(lead_mm) {}
  [[nodiscard]] double turns_at_height(double above_pivot_mm) const;
  [[nodiscard]] std::vector<MotorReach> intervals() const;

  LinkageParameters parameters_;
  double lead_mm_;
};

struct GripperMotor {
  double lead_mm = 0;  ///< travel of the nut along +z in one turn; below 0 towards the palm
  double first_turns = 0, last_turns = 0;  ///< range of the motor, first below last
  /// Standard deviation of a motor position, with the screw's play; [0, 1000].
  double sd_turns = 0;
};

struct GripperFinger {
  std::string name;
  /// The finger's folder, relative to that of gripper.yaml.
  std::string folder;
  LinkageParameters linkage;
  /// Pose of the camera on the finger's link. Exactly one of the two is given:
  std::optional<RigidTransform> link_from_camera;
  /// the motor position at which `gripper_from_camera` of the finger's own file holds.
  std::optional<double> known_at_turns;
};

/// The pose of one finger at a motor position.
struct FingerPose {
  RigidTransform gripper_from_camera;
  LinkageAngle angle;
  /// Of the angle, from the motor's sd; empty in a dead point, where the linearisation fails.
  std::optional<double> angle_sd_rad;
  Eigen::Vector3d pivot_mm;  ///< a point of the finger's axis, in the gripper

  /// Velocity of a point that moves with the finger, mm per turn of the motor.
  [[nodiscard]] Eigen::Vector3d rate_mm(const Eigen::Vector3d& in_gripper_mm) const {
    return angle.rad_per_turn * Eigen::Vector3d::UnitY().cross(in_gripper_mm - pivot_mm);
  }
};

/// Both fingers at one motor position, whose error they share.
struct GripperPose {
  double motor_turns = 0, sd_turns = 0;
  std::array<FingerPose, 2> fingers;
};

/// A value: the content of gripper.yaml.
class Gripper {
 public:
  static constexpr const char* kFormat = "alltact-gripper/1";
  static constexpr const char* kFileName = "gripper.yaml";

  std::string name;
  GripperMotor motor;
  std::array<GripperFinger, 2> fingers;

  /// Reads gripper.yaml, by its own path or that of its folder. Where a finger's own file holds its
  /// pose, reads that too (resolve_camera_poses). As strict as Finger::load, with the same advice
  /// in errors.
  static Result<Gripper> load(const std::filesystem::path& path,
                              std::vector<Message>* warnings = nullptr);

  /// The file's content alone; `origin` names it in errors.
  static Result<Gripper> parse(const std::string& yaml, const std::filesystem::path& origin,
                               std::vector<Message>* warnings = nullptr);

  /// Computes link_from_camera of fingers with known_at_turns, and clears the latter. The fingers'
  /// folders are relative to `folder`. Errors: those of Finger::load; the finger's file lacks
  /// gripper_from_camera.
  [[nodiscard]] Status resolve_camera_poses(const std::filesystem::path& folder);

  /// Writes the full file or nothing; an invalid gripper is refused.
  [[nodiscard]] Status save(const std::filesystem::path& file) const;
  [[nodiscard]] Result<std::string> to_yaml() const;

  /// The error's `where` is the key ("fingers[1].rod_mm"). Both loops close over the motor's full
  /// range without a dead point that ends their reach.
  [[nodiscard]] Status validate() const;

  /// Poses of both fingers. The motor position may exceed its range by a millionth of it.
  ///   sd_turns: of this position; empty: motor.sd_turns
  /// Errors: outside the motor's range or the linkage's reach; a camera pose that is not known yet.
  [[nodiscard]] Result<GripperPose> pose_at(double motor_turns,
                                            std::optional<double> sd_turns = {}) const;

  /// Dead points of a finger's linkage within the motor's range, where the finger stands still
  /// while the screw turns.
  [[nodiscard]] std::vector<DeadPoint> dead_points_in_range(std::size_t finger) const;

 private:
  [[nodiscard]] std::optional<Error> finger_problem(std::size_t finger) const;
  struct Unknown;  // keys of the file that this version does not know
  std::shared_ptr<const Unknown> unknown_;
};

/// gripper_from_link of a finger whose crank is at an angle.
[[nodiscard]] RigidTransform gripper_from_link(const LinkageParameters& linkage, double angle_rad);

}  // namespace alltact
