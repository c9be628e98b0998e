#include "calibration/live/body_comparison.h"

#include "calibration/joint/body_pose.h"
#include "calibration/presses/press.h"
#include "core/numerics/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using Eigen::Vector3d;

constexpr double kPressedPart = 1.0 / 3;  // of the greatest depth: skin that lies on the body
constexpr int kFewest = 60;               // pixels of it
constexpr std::size_t kMostPoints = 1500;
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// The largest connected part that is deeper than a fraction of its depth; single pixels may be
/// noise, so the greatest depth is that of a smoothed map. Empty: nothing is pressed in.
cv::Mat pressed_mask(const cv::Mat& depth_mm) {
  const cv::Mat known = measured_pixels(depth_mm);
  cv::Mat smooth = depth_mm.clone(), labels, stats, middles;
  smooth.setTo(0.0F, ~known);
  cv::GaussianBlur(smooth, smooth, {}, 1.5);
  double deepest_mm = 0;
  cv::minMaxLoc(smooth, nullptr, &deepest_mm);
  if (!(deepest_mm > 0)) return {};
  const cv::Mat pressed = (smooth > kPressedPart * deepest_mm) & known;
  const int count = cv::connectedComponentsWithStats(pressed, labels, stats, middles);
  int largest = 0;
  for (int label = 1; label < count; ++label)
    if (largest == 0 ||
        stats.at<int>(label, cv::CC_STAT_AREA) > stats.at<int>(largest, cv::CC_STAT_AREA))
      largest = label;
  if (largest == 0 || stats.at<int>(largest, cv::CC_STAT_AREA) < kFewest) return {};
  return labels == largest;
}

Vector3d untouched_mm(const cv::Mat& points_mm, const cv::Mat& depth_mm, int v, int u) {
  const auto& at = points_mm.at<cv::Vec3f>(v, u);
  return {at[0], at[1], at[2] + depth_mm.at<float>(v, u)};
}

/// Skin in the mask, spread evenly.
std::vector<SkinPoint> skin_in(const cv::Mat& mask, const cv::Mat& points_mm,
                               const cv::Mat& depth_mm) {
  const int pixels = cv::countNonZero(mask);
  const auto step = std::max(
      1, static_cast<int>(std::lround(std::sqrt(pixels / static_cast<double>(kMostPoints)))));
  std::vector<SkinPoint> skin;
  for (int v = 0; v < mask.rows; v += step)
    for (int u = 0; u < mask.cols; u += step) {
      if (mask.at<std::uint8_t>(v, u) == 0) continue;
      const Vector3d base = untouched_mm(points_mm, depth_mm, v, u);
      if (base.allFinite()) skin.push_back({{base, Vector3d::UnitZ()}, depth_mm.at<float>(v, u)});
    }
  return skin;
}

/// A body in its pose, and a depth that none of it reaches.
struct BodyInPose {
  const MeshDistance& shape;
  const Eigen::Isometry3d& camera_from_body;
  double beyond_mm;

  [[nodiscard]] double gap_mm(const Vector3d& point) const {
    return gap_at(shape, camera_from_body, point).mm;
  }
};

/// Where the body's surface lies on a line along z, as a depth from the untouched face: the first
/// point of the body seen from the camera's side. nullopt: it does not press in there.
std::optional<double> depth_at(const BodyInPose& body, const Vector3d& untouched) {
  constexpr double kCloseMm = 1e-4;
  constexpr int kSteps = 200;
  double depth_mm = body.beyond_mm;
  for (int i = 0; i < kSteps && depth_mm > 0; ++i) {
    const double gap_mm = body.gap_mm(untouched - depth_mm * Vector3d::UnitZ());
    if (gap_mm < 0 && i == 0) return std::nullopt;
    if (gap_mm < kCloseMm) return depth_mm;
    depth_mm -= gap_mm;  // no surface is nearer in any direction
  }
  return std::nullopt;
}

/// NaN where the body does not press in.
cv::Mat depths_of(const BodyInPose& body, const cv::Mat& points_mm, const cv::Mat& depth_mm) {
  cv::Mat depths(depth_mm.size(), CV_32FC1, cv::Scalar(kNaN));
  parallel_for(depth_mm.rows, default_threads(), [&](int first, int last) {
    // A gap changes by no more than the distance between two points: near pixels that the body
    // cannot reach are passed over.
    Vector3d known = Vector3d::Zero();
    double known_gap_mm = -1;
    for (int v = first; v < last; ++v)
      for (int u = 0; u < depth_mm.cols; ++u) {
        const Vector3d untouched = untouched_mm(points_mm, depth_mm, v, u);
        if (!untouched.allFinite()) continue;
        if (known_gap_mm - (untouched - known).norm() > body.beyond_mm) continue;
        known = untouched;
        known_gap_mm = body.gap_mm(untouched);
        if (known_gap_mm > body.beyond_mm) continue;
        if (const auto depth = depth_at(body, untouched))
          depths.at<float>(v, u) = static_cast<float>(*depth);
      }
  });
  return depths;
}

/// See PosedNominal::distance_mm.
cv::Mat distances_of(const BodyInPose& body, const FrameResult& result, const cv::Mat& points_mm) {
  const cv::Mat& depth_mm = result.depth->depth_mm;
  cv::Mat distances(depth_mm.size(), CV_32FC1, cv::Scalar(kNaN));
  parallel_for(depth_mm.rows, default_threads(), [&](int first, int last) {
    Vector3d known = Vector3d::Zero();
    double known_gap_mm = -1;
    for (int v = first; v < last; ++v)
      for (int u = 0; u < depth_mm.cols; ++u) {
        const auto& at = points_mm.at<cv::Vec3f>(v, u);
        const Vector3d skin(at[0], at[1], at[2]);
        const auto local = result.shape->at(u, v);
        const double below_mm =
            local ? depth_mm.at<float>(v, u) * std::abs(local->cos_incline) : kNaN;
        if (!skin.allFinite() || !std::isfinite(below_mm)) continue;
        // As in depths_of(): the body is farther than the untouched skin.
        const bool is_far = known_gap_mm - (skin - known).norm() > std::max(below_mm, 0.0);
        if (!is_far) {
          known = skin;
          known_gap_mm = body.gap_mm(skin);
        }
        const double distance_mm = is_far             ? below_mm
                                   : known_gap_mm < 0 ? known_gap_mm
                                                      : std::min(known_gap_mm, below_mm);
        distances.at<float>(v, u) = static_cast<float>(distance_mm);
      }
  });
  return distances;
}

}  // namespace

Result<PosedNominal> pose_nominal(const FrameResult& result, const Face& face,
                                  const MeshDistance& body, const Job& job) {
  const cv::Mat& depth_mm = result.depth->depth_mm;
  const cv::Mat mask = pressed_mask(depth_mm);
  const cv::Mat points_mm = contact_face_points_mm(result, face);
  const auto skin = mask.empty() ? std::vector<SkinPoint>() : skin_in(mask, points_mm, depth_mm);
  if (skin.size() < kFewest)
    return Error{en::say("too little of the face is pressed in to find the body's pose"), "",
                 en::say("a frame with a deeper or wider contact")};
  Vector3d normal = Vector3d::UnitZ();
  const cv::Moments moments = cv::moments(mask, true);
  if (const auto local = result.shape->at(moments.m10 / moments.m00, moments.m01 / moments.m00))
    normal = local->normal;
  const auto found = find_pose(skin, normal, body, false, job);
  if (!found) return found.error();
  BodyPose posed = *found;
  constexpr int kRounds = 10;
  const BodySurface surface(body);
  for (int i = 0; i < kRounds; ++i) refine_pose(skin, surface, false, posed);
  PosedNominal nominal;
  nominal.camera_from_body = posed.camera_from_body;
  const Eigen::VectorXd gaps_mm = gaps_at(skin, surface, posed.camera_from_body, 1.0).mm;
  nominal.rms_mm = std::sqrt(gaps_mm.squaredNorm() / static_cast<double>(gaps_mm.size()));
  double deepest_mm = 0;
  for (const SkinPoint& point : skin) deepest_mm = std::max(deepest_mm, point.depth_mm);
  constexpr double kWorstPart = 0.5;
  if (!(nominal.rms_mm < kWorstPart * deepest_mm))
    return Error{en::say("the skin is {:.2f} mm off the body in its best pose", nominal.rms_mm), "",
                 en::say("a mesh of the body that presses, in millimetres")};
  const BodyInPose in_pose{body, posed.camera_from_body, 2.0 * face.layer_mm + deepest_mm};
  nominal.depth_mm = depths_of(in_pose, points_mm, depth_mm);
  nominal.distance_mm = distances_of(in_pose, result, points_mm);
  if (job.stop_requested()) return Error{en::say("stopped before the body was compared"), "", ""};
  return nominal;
}

}  // namespace alltact
