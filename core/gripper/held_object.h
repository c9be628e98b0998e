// Measurements of one object held by two fingers, in the gripper's frame: its width, and the
// rotation that brings it upright.
#pragma once

#include "core/gripper/gripper.h"
#include "core/sensing/contact/contact_regions.h"

#include <array>
#include <functional>
#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A contact as one finger's camera measures it.
struct ObservedContact {
  Eigen::Vector3d position_mm;  ///< on the pressed face, camera frame
  std::optional<Eigen::Matrix3d> position_covariance_mm2;
  std::optional<Eigen::Vector3d> axis;         ///< unit, camera frame; empty if round
  std::optional<double> axis_sd_deg;           ///< within the face
  std::optional<Eigen::Vector3d> face_normal;  ///< unit, camera frame; with `axis`
};
[[nodiscard]] ObservedContact observed_contact(const ContactRegion& region);

/// The extent of the held object along x of the gripper, the direction in which the fingers close.
/// It is measured between the two contact positions, so on a round object it is smaller by the
/// rounding over the contacts. The positions' errors are independent; the motor's error moves both.
/// `sd_mm` is empty where a covariance is, or in a dead point.
struct HeldWidth {
  double mm = 0;
  std::optional<double> sd_mm;
  /// From the first position to the second, in the gripper; along x alone where they are opposed.
  Eigen::Vector3d separation_mm;
};
[[nodiscard]] HeldWidth held_width(const GripperPose& pose,
                                   const std::array<ObservedContact, 2>& contacts);

/// In degrees, with its standard deviation.
struct UprightTurn {
  double deg = 0, sd_deg = 0;
};

/// The angle by which the gripper must rotate about its x axis (right-handed) so that the contact's
/// axis, viewed along x, lies along `up`. It lies in (-90, 90], since an axis has no direction.
/// With t the axis and u the upward direction, both without their x,
///   turn = angle from t to u about x, modulo 180 degrees.
/// The paper rotates the gripper by the angle of one image's principal axis; here the face may be
/// inclined and the finger rotated.
///   up: in the gripper's frame, any length above 0
/// The sd is that of the axis and of the motor. nullopt: the contact is round, or its axis or `up`
/// lies within 10 degrees of x, about which no rotation changes it.
[[nodiscard]] std::optional<UprightTurn> upright_turn_deg(const GripperPose& pose,
                                                          std::size_t finger,
                                                          const ObservedContact& contact,
                                                          const Eigen::Vector3d& up);

/// Both fingers' rotations combined.
struct JointTurn {
  UprightTurn mean;
  double difference_deg = 0;  ///< difference of the two, [0, 90]
  double difference_sds = 0;  ///< the same in standard deviations of their difference
  /// False: they differ by more than 4 standard deviations. Then one error is larger than its sd,
  /// or the fingers do not hold one straight object.
  bool agree = true;
};
/// Mean of axial data: of the doubled angles, each by 1/variance (N. I. Fisher, Statistical
/// Analysis of Circular Data, 1993, 2.3.3 and 4.4). nullopt: they are at right angles with equal
/// sd, which has no mean.
[[nodiscard]] std::optional<JointTurn> joint_turn(const UprightTurn& first,
                                                  const UprightTurn& second);

// Distance between the faces of two fingers.

/// A face as its finger's camera measures it.
struct GapFace {
  cv::Mat points_mm;  ///< CV_32FC3, contact_face_points_mm(): camera frame, NaN off the face
  /// Standard deviation of the face's z in a column, mm (FaceColumn::z_sd_mm); empty or nullopt:
  /// unknown.
  std::function<std::optional<double>(double u)> z_sd_mm;
  double correlated_px2 = 22.0;  ///< pixels that share their noise; 22 for the default smoothing
};

struct FaceGap {
  double mm = 0;                        ///< below 0 where the faces' noise lets them overlap
  std::optional<double> sd_mm;          ///< empty where a face's z_sd_mm is, or in a dead point
  Eigen::Vector3d first_mm, second_mm;  ///< nearest points, in the gripper
};

/// The minimum distance of both faces. The nearest points of two noisy surfaces are biased by
/// noise. A quadric is therefore fitted to each face around them, over the plane across the gap. It
/// uses 1.5 mm around, or more until that holds 60 pixels; the distance is taken between the
/// quadrics. The sd combines both fits (from their residuals), the faces' z along the line of
/// sight, and the motor, which moves both. nullopt: a face has too few pixels for a quadric, or no
/// surface.
[[nodiscard]] std::optional<FaceGap> face_gap(const GripperPose& pose,
                                              const std::array<GapFace, 2>& faces);

}  // namespace alltact
