#include "core/gripper/held_object.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kDegree = std::numbers::pi / 180;
const double kMinAcross = std::sin(10 * kDegree);  // of a unit axis, across x
constexpr double kMinSd_deg = 1e-6;                // lower bound for weights

/// Wraps to (-90, 90].
double axial(double deg) {
  const double turned = std::remainder(deg, 180.0);
  return turned <= -90.0 ? turned + 180.0 : turned;
}

/// About x from y, degrees.
double about_x_deg(const Eigen::Vector3d& direction) {
  return std::atan2(direction.z(), direction.y()) / kDegree;
}

/// The standard deviation, from a function's values one sd to either side.
double half_difference_deg(double more_deg, double less_deg) {
  return 0.5 * std::abs(axial(more_deg - less_deg));
}

}  // namespace

ObservedContact observed_contact(const ContactRegion& region) {
  return {region.position_mm,
          region.position_covariance_mm2,
          region.axis,
          region.axis ? region.angle_sd_deg : std::nullopt,
          region.normal};
}

HeldWidth held_width(const GripperPose& pose, const std::array<ObservedContact, 2>& contacts) {
  std::array<Eigen::Vector3d, 2> in_gripper_mm;
  double variance = 0, rate_mm = 0;
  bool has_sd = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const FingerPose& finger = pose.fingers[i];
    in_gripper_mm[i] = finger.gripper_from_camera.point(contacts[i].position_mm);
    if (contacts[i].position_covariance_mm2 && finger.angle_sd_rad) {
      const Eigen::Vector3d closing =
          finger.gripper_from_camera.inverse().direction(Eigen::Vector3d::UnitX());
      variance += std::max(0.0, closing.dot(*contacts[i].position_covariance_mm2 * closing));
      rate_mm += (i == 0 ? -1.0 : 1.0) * finger.rate_mm(in_gripper_mm[i]).x();
    } else {
      has_sd = false;
    }
  }
  HeldWidth width{0, {}, in_gripper_mm[1] - in_gripper_mm[0]};
  width.mm = std::abs(width.separation_mm.x());
  if (has_sd) width.sd_mm = std::hypot(std::sqrt(variance), rate_mm * pose.sd_turns);
  return width;
}

std::optional<UprightTurn> upright_turn_deg(const GripperPose& pose,
                                            std::size_t finger,
                                            const ObservedContact& contact,
                                            const Eigen::Vector3d& up) {
  if (!contact.axis || !contact.axis_sd_deg || !contact.face_normal || !(up.norm() > 0))
    return std::nullopt;
  const FingerPose& finger_pose = pose.fingers[finger];
  const Eigen::Vector3d up_unit = up.normalized();
  const auto turned = [&](double within_face_rad, double about_y_rad) {
    const Eigen::Vector3d on_face =
        Eigen::AngleAxisd(within_face_rad, contact.face_normal->normalized()) * *contact.axis;
    return Eigen::Vector3d(Eigen::AngleAxisd(about_y_rad, Eigen::Vector3d::UnitY()) *
                           finger_pose.gripper_from_camera.direction(on_face));
  };
  const Eigen::Vector3d axis = turned(0, 0);
  if (!(axis.tail<2>().norm() >= kMinAcross * axis.norm()) ||
      !(up_unit.tail<2>().norm() >= kMinAcross) || !finger_pose.angle_sd_rad)
    return std::nullopt;
  const auto turn_of = [&](const Eigen::Vector3d& along) {
    return axial(about_x_deg(up_unit) - about_x_deg(along));
  };
  const double face = *contact.axis_sd_deg * kDegree, motor = *finger_pose.angle_sd_rad;
  const double by_face = half_difference_deg(turn_of(turned(face, 0)), turn_of(turned(-face, 0)));
  const double by_motor =
      half_difference_deg(turn_of(turned(0, motor)), turn_of(turned(0, -motor)));
  return UprightTurn{turn_of(axis), std::hypot(by_face, by_motor)};
}

std::optional<JointTurn> joint_turn(const UprightTurn& first, const UprightTurn& second) {
  const auto weight = [](const UprightTurn& one) {
    return std::pow(std::max(one.sd_deg, kMinSd_deg), -2);
  };
  const double first_weight = weight(first), second_weight = weight(second),
               weights = first_weight + second_weight;
  const auto doubled = [](const UprightTurn& one) {
    const double rad = 2 * one.deg * kDegree;
    return Eigen::Vector2d(std::cos(rad), std::sin(rad));
  };
  const Eigen::Vector2d sum =
      (first_weight * doubled(first) + second_weight * doubled(second)) / weights;
  if (!(sum.norm() > 1e-6)) return std::nullopt;
  JointTurn joint;
  joint.mean.deg = axial(0.5 * std::atan2(sum.y(), sum.x()) / kDegree);
  joint.mean.sd_deg = 1 / std::sqrt(weights);
  joint.difference_deg = std::abs(axial(first.deg - second.deg));
  joint.difference_sds = joint.difference_deg / std::sqrt(1 / first_weight + 1 / second_weight);
  constexpr double kMaxSds = 4;
  joint.agree = joint.difference_sds <= kMaxSds;
  return joint;
}

}  // namespace alltact
