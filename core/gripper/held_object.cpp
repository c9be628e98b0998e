#include "core/gripper/held_object.h"

#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

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
  return {region.position_mm, region.position_covariance_mm2, region.axis,
          region.axis ? region.angle_sd_deg : std::nullopt, region.normal};
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

std::optional<UprightTurn> upright_turn_deg(const GripperPose& pose, std::size_t finger,
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

namespace {

constexpr double kRadius_mm = 1.5, kMaxRadius_mm = 6.0;
constexpr std::size_t kMinPixels = 60;
constexpr double kMinGap_mm = 0.1;  // below it the nearest points give no direction

struct GapPixel {
  Eigen::Vector3d in_gripper_mm;
  int u;
};

/// Height over the plane across the gap at the centre of a patch, with the variance of the fit.
struct GapHeight {
  double mm = 0, variance_mm2 = 0;
  int middle_u = 0;  ///< column of the nearest pixel
};

std::vector<GapPixel> pixels_around(const cv::Mat& points_mm, const RigidTransform& camera_pose,
                                    const Eigen::Vector3d& middle_mm, double radius_mm) {
  const Eigen::Vector3d seen = camera_pose.inverse().point(middle_mm);
  std::vector<GapPixel> pixels;
  for (int v = 0; v < points_mm.rows; ++v) {
    const auto* row = points_mm.ptr<cv::Vec3f>(v);
    for (int u = 0; u < points_mm.cols; ++u) {
      const Eigen::Vector3d p(static_cast<double>(row[u][0]), static_cast<double>(row[u][1]),
                              static_cast<double>(row[u][2]));
      if ((p - seen).squaredNorm() <= radius_mm * radius_mm)
        pixels.push_back({camera_pose.point(p), u});
    }
  }
  return pixels;
}

std::optional<GapHeight> quadric_height(const std::vector<GapPixel>& pixels,
                                        const Eigen::Vector3d& middle_mm,
                                        const Eigen::Matrix3d& across_and_gap,
                                        double correlated_px2) {
  constexpr int kTerms = 6;
  if (pixels.size() < kMinPixels) return std::nullopt;
  Eigen::Matrix<double, kTerms, kTerms> normal = Eigen::Matrix<double, kTerms, kTerms>::Zero();
  Eigen::Vector<double, kTerms> right = Eigen::Vector<double, kTerms>::Zero();
  double squares = 0;
  GapHeight height;
  double nearest = std::numeric_limits<double>::infinity();
  for (const GapPixel& pixel : pixels) {
    const Eigen::Vector3d at = across_and_gap.transpose() * (pixel.in_gripper_mm - middle_mm);
    const double a = at.x(), b = at.y();
    const Eigen::Vector<double, kTerms> terms{1.0, a, b, a * a, a * b, b * b};
    normal += terms * terms.transpose();
    right += at.z() * terms;
    squares += at.z() * at.z();
    if (const double far = at.squaredNorm(); far < nearest)
      nearest = far, height.middle_u = pixel.u;
  }
  const Eigen::LDLT<Eigen::Matrix<double, kTerms, kTerms>> solver(normal);
  if (!(solver.rcond() > 1e-10)) return std::nullopt;  // pixels in a line span no plane
  const Eigen::Vector<double, kTerms> fit = solver.solve(right);
  const double residual =
      std::max(0.0, squares - fit.dot(right)) / (static_cast<double>(pixels.size()) - kTerms);
  const double at_middle = solver.solve(Eigen::Vector<double, kTerms>::Unit(0))[0];
  height.mm = fit[0];
  height.variance_mm2 = residual * correlated_px2 * at_middle;
  return height;
}

/// Variance of the face's z error, projected on the gap.
std::optional<double> sight_variance(const GapFace& face, const RigidTransform& camera_pose,
                                     const Eigen::Vector3d& at_mm, const Eigen::Vector3d& gap,
                                     int u) {
  const auto z_sd = face.z_sd_mm ? face.z_sd_mm(u) : std::nullopt;
  const Eigen::Vector3d seen = camera_pose.inverse().point(at_mm);
  if (!z_sd || !(std::abs(seen.z()) > 0)) return std::nullopt;
  const double along = gap.dot(camera_pose.direction(seen / seen.z())) * *z_sd;
  return along * along;
}

/// Two directions orthogonal to a third, which is the last column.
Eigen::Matrix3d frame_about(const Eigen::Vector3d& gap) {
  Eigen::Matrix3d frame;
  frame.col(0) = gap.unitOrthogonal();
  frame.col(1) = gap.cross(frame.col(0));
  frame.col(2) = gap;
  return frame;
}

}  // namespace

std::optional<FaceGap> face_gap(const GripperPose& pose, const std::array<GapFace, 2>& faces) {
  for (const GapFace& face : faces)
    if (face.points_mm.type() != CV_32FC3) return std::nullopt;
  const RigidTransform &first = pose.fingers[0].gripper_from_camera,
                       &second = pose.fingers[1].gripper_from_camera;
  const auto nearest =
      nearest_points(PosedSurface{faces[0].points_mm, first}, {faces[1].points_mm, second});
  if (!nearest) return std::nullopt;
  const Eigen::Vector3d apart = nearest->second - nearest->first;
  // For faces in contact the gap runs along the closing direction.
  const double closing_sign = second.translation_mm.x() < first.translation_mm.x() ? -1.0 : 1.0;
  const Eigen::Vector3d gap = nearest->distance() > kMinGap_mm
                                  ? Eigen::Vector3d(apart.normalized())
                                  : Eigen::Vector3d(closing_sign * Eigen::Vector3d::UnitX());
  const Eigen::Matrix3d frame = frame_about(gap);
  FaceGap found{gap.dot(apart), {}, nearest->first, nearest->second};
  double variance = 0, rate_mm = 0;
  bool has_sd = true;
  for (std::size_t i = 0; i < 2; ++i) {
    const FingerPose& finger = pose.fingers[i];
    Eigen::Vector3d& at = i == 0 ? found.first_mm : found.second_mm;
    std::optional<GapHeight> height;
    for (double radius = kRadius_mm; !height && radius <= kMaxRadius_mm; radius *= 2)
      height =
          quadric_height(pixels_around(faces[i].points_mm, finger.gripper_from_camera, at, radius),
                         at, frame, faces[i].correlated_px2);
    if (!height) return std::nullopt;
    at += height->mm * gap;
    const double side = i == 0 ? -1.0 : 1.0;
    found.mm += side * height->mm;
    variance += height->variance_mm2;
    const auto sight =
        sight_variance(faces[i], finger.gripper_from_camera, at, gap, height->middle_u);
    has_sd = has_sd && sight && finger.angle_sd_rad;
    if (!has_sd) continue;
    variance += *sight;
    rate_mm += side * gap.dot(finger.rate_mm(at));
  }
  if (has_sd) found.sd_mm = std::hypot(std::sqrt(variance), rate_mm * pose.sd_turns);
  return found;
}

}  // namespace alltact
