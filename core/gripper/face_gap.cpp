#include "core/gripper/face_gap.h"

#include "core/geometry/surface_distance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include <Eigen/Dense>

namespace alltact {
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

std::vector<GapPixel> pixels_around(const cv::Mat& points_mm,
                                    const RigidTransform& camera_pose,
                                    const Eigen::Vector3d& middle_mm,
                                    double radius_mm) {
  const Eigen::Vector3d seen = camera_pose.inverse().point(middle_mm);
  std::vector<GapPixel> pixels;
  for (int v = 0; v < points_mm.rows; ++v) {
    const auto* row = points_mm.ptr<cv::Vec3f>(v);
    for (int u = 0; u < points_mm.cols; ++u) {
      const Eigen::Vector3d p(static_cast<double>(row[u][0]),
                              static_cast<double>(row[u][1]),
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
std::optional<double> sight_variance(const GapFace& face,
                                     const RigidTransform& camera_pose,
                                     const Eigen::Vector3d& at_mm,
                                     const Eigen::Vector3d& gap,
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
                         at,
                         frame,
                         faces[i].correlated_px2);
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
