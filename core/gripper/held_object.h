// What two fingers that touch one object tell of it, in the gripper's frame: how wide it is, and by
// how much the gripper must turn to bring it upright.
#pragma once

#include "core/gripper/gripper.h"
#include "core/sensing/contact/contact_regions.h"

#include <array>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// A contact as one finger's camera tells it.
struct SeenContact {
  Eigen::Vector3d place_mm;  ///< on the pressed face, camera frame
  std::optional<Eigen::Matrix3d> place_covariance_mm2;
  std::optional<Eigen::Vector3d> axis;         ///< unit, camera frame; absent where it is round
  std::optional<double> axis_sd_deg;           ///< within the face
  std::optional<Eigen::Vector3d> face_normal;  ///< unit, camera frame; with `axis`
};
[[nodiscard]] SeenContact seen_contact(const ContactRegion& region);

/// The extent of the held object along x of the gripper, the direction in which the fingers close:
/// from one contact's place to the other's, so of a round object less by what it is rounded by over
/// the contacts. The places' errors are independent, the motor's moves both; `sd_mm` is absent
/// where a covariance is, or in a dead point.
struct HeldWidth {
  double mm = 0;
  std::optional<double> sd_mm;
  /// From the first place to the second, in the gripper; along x alone where they oppose each
  /// other.
  Eigen::Vector3d apart_mm;
};
[[nodiscard]] HeldWidth held_width(const GripperPose& pose,
                                   const std::array<SeenContact, 2>& contacts);

/// In degrees, with its standard deviation.
struct UprightTurn {
  double deg = 0, sd_deg = 0;
};

/// By how many degrees the gripper must turn about its x axis, as a right hand's fingers go about
/// x, so that the contact's axis, seen along x, lies along `up`: in (-90, 90], since an axis has no
/// direction. With t the axis and u the way up, both without their x,
///   turn = angle from t to u about x, modulo 180 degrees.
/// The paper turns the gripper by the angle of one picture's principal axis; here the face may be
/// inclined and the finger turned.
///   up: in the gripper's frame, any length above 0
/// The sd is that of the axis and of the motor. nullopt: the contact is round, or its axis or `up`
/// lies within 10 degrees of x, about which no turn changes it.
[[nodiscard]] std::optional<UprightTurn> upright_turn_deg(const GripperPose& pose,
                                                          std::size_t finger,
                                                          const SeenContact& contact,
                                                          const Eigen::Vector3d& up);

/// Both fingers' turns as one.
struct JointTurn {
  UprightTurn mean;
  double apart_deg = 0;  ///< by how much they differ, [0, 90]
  double apart_sds = 0;  ///< the same in standard deviations of their difference
  /// False: they differ by more than 4 standard deviations, so one of them errs by more than it
  /// says, or they do not touch one straight object.
  bool agree = true;
};
/// Mean of axial data: of the doubled angles, each by 1/variance (N. I. Fisher, Statistical
/// Analysis of Circular Data, 1993, 2.3.3 and 4.4). nullopt where they are at right angles and
/// equally sure, which has no mean.
[[nodiscard]] std::optional<JointTurn> joint_turn(const UprightTurn& first,
                                                  const UprightTurn& second);

}  // namespace alltact
