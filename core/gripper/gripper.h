// Gripper: two fingers, the screw that moves them, and the poses of their cameras for a motor
// position.
//
// FRAMES. The gripper's frame is fixed in its body: x is the direction in which the fingers close,
// y is parallel to their rotation axes, z runs along the screw away from the palm. A finger's link
// moves with its crank: origin on the finger's axis at y = 0, z along the crank, y as the
// gripper's. With the crank's angle t (linkage.h)
//   gripper_from_link   = rotation by t about y, then shift to the pivot
//   gripper_from_camera = gripper_from_link * link_from_camera
//
//   const auto gripper = Gripper::load("gripper");           // gripper/gripper.yaml
//   const auto pose = gripper->pose_at(3.2);                 // turns
//   pose->fingers[0].gripper_from_camera.point(position_mm);    // finger 0's contact, in the
//   gripper
#pragma once

#include "core/geometry/rigid_transform.h"
#include "core/gripper/linkage.h"
#include "core/message.h"
#include "core/result.h"

#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

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
  static Result<Gripper> parse(const std::string& yaml,
                               const std::filesystem::path& origin,
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
