#include "core/sensing/depth/depth_map.h"

#include <cmath>

#include <gtest/gtest.h>

namespace alltact {
namespace {

/// A plane face z = z0 + m X seen by a pinhole, so that every line of sight and every normal can be
/// intersected by hand.
struct InclinedPlane {
  double z0 = 50.0, m = 0.6;
  Camera camera;
  FaceShape shape;

  static Camera make_camera() {
    CameraParameters p;
    p.width_px = 960, p.height_px = 540;
    p.fx_px = p.fy_px = 523.9;
    p.cx_px = 479.5, p.cy_px = 269.5;
    return Camera::create(p).value();
  }
  static Face face() {
    Face f;
    f.width_mm = 24.0;
    f.layer_mm = 1.5;
    return f;
  }
  static FaceShape make_shape(const Camera& camera, double z0, double m) {
    FaceEdges edges;
    for (double u = 3.5; u < 960.0; u += 8.0) {
      const double x = (u - 479.5) / 523.9, z = z0 / (1.0 - m * x);
      edges.u.push_back(u);
      for (const double side : {-1.0, 1.0}) {
        Edge& edge = side < 0.0 ? edges.upper : edges.lower;
        edge.v.push_back(269.5 + side * 523.9 * 12.0 / z);
        edge.sd.push_back(0.02);
        edge.valid.push_back(edge.v.back() > 0.0 && edge.v.back() < 539.0);
      }
    }
    return FaceShape::fit(edges, camera, face(), 5).value();
  }
  InclinedPlane() : camera(make_camera()), shape(make_shape(camera, z0, m)) {}
};

/// The ball's near side on a line, mm along `direction` from `from`; NaN where it passes by.
double ball_at(const Eigen::Vector3d& from, const Eigen::Vector3d& direction,
               const Eigen::Vector3d& centre, double radius) {
  const Eigen::Vector3d to = centre - from;
  const double along = to.dot(direction);
  const double square = radius * radius - (to - along * direction).squaredNorm();
  return square > 0.0 ? along - std::sqrt(square) : NAN;
}

cv::Mat turned(const cv::Mat& along_normal, const FaceShape& shape) {
  cv::Mat flags = cv::Mat::zeros(along_normal.size(), CV_8UC1);
  return depth_along_z(along_normal, depth_cells(along_normal), shape, flags);
}

TEST(DepthAlongZ, IsThatOfTheSameBallOnAnInclinedFace) {
  const InclinedPlane plane;
  const double layer = 1.5, radius = 4.0, pressed = 0.8;
  const auto middle = plane.shape.at(520.0, 280.0);
  ASSERT_TRUE(middle);
  const Eigen::Vector3d centre =
      middle->view_point_mm + (layer - pressed + radius) * middle->normal;
  cv::Mat along_normal(540, 960, CV_32FC1, cv::Scalar(NAN));
  cv::Mat along_z(540, 960, CV_32FC1, cv::Scalar(NAN));
  for (int v = 0; v < 540; ++v) {
    for (int u = 0; u < 960; ++u) {
      const auto local = plane.shape.at(u, v);
      if (!local) continue;
      const double n = ball_at(local->view_point_mm, local->normal, centre, radius);
      along_normal.at<float>(v, u) =
          static_cast<float>(std::isfinite(n) ? std::max(0.0, layer - n) : 0.0);
      const double thickness = layer / local->cos_incline;
      const double z = ball_at(local->view_point_mm, Eigen::Vector3d::UnitZ(), centre, radius);
      along_z.at<float>(v, u) =
          static_cast<float>(std::isfinite(z) ? std::max(0.0, thickness - z) : 0.0);
    }
  }
  const cv::Mat found = turned(along_normal, plane.shape);
  double worst = 0, scaled_worst = 0;
  int touched = 0;
  for (int v = 0; v < 540; ++v) {
    for (int u = 0; u < 960; ++u) {
      const double truth = static_cast<double>(along_z.at<float>(v, u));
      if (!(truth > 0.0)) continue;
      ++touched;
      const double error = static_cast<double>(found.at<float>(v, u)) - truth;
      worst = std::max(worst, std::abs(error));
      const double scaled =
          static_cast<double>(along_normal.at<float>(v, u)) * std::hypot(1.0, plane.m);
      scaled_worst = std::max(scaled_worst, std::abs(scaled - truth));
    }
  }
  EXPECT_GT(touched, 1000);
  EXPECT_LT(worst, 0.02);        // the rim has a corner; bilinear look-up rounds it
  EXPECT_GT(scaled_worst, 0.2);  // what is wrong without looking elsewhere
}

/// Skin that bulges outwards as the cap of a ball does, measured along the normal and along z.
TEST(DepthAlongZ, IsThatOfTheSameBulgeOnAnInclinedFace) {
  const InclinedPlane plane;
  const double layer = 1.5, radius = 12.0, height = 0.3;
  const auto middle = plane.shape.at(520.0, 280.0);
  ASSERT_TRUE(middle);
  const Eigen::Vector3d centre = middle->view_point_mm + (layer + height - radius) * middle->normal;
  const auto beyond = [&](const Eigen::Vector3d& from, const Eigen::Vector3d& way) {
    const Eigen::Vector3d to = centre - from;
    const double along = to.dot(way);
    return along + std::sqrt(radius * radius - (to - along * way).squaredNorm());
  };
  cv::Mat along_normal(540, 960, CV_32FC1, cv::Scalar(NAN)), along_z = along_normal.clone();
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u) {
      const auto local = plane.shape.at(u, v);
      if (!local) continue;
      const double n = beyond(local->view_point_mm, local->normal);
      const double z = beyond(local->view_point_mm, Eigen::Vector3d::UnitZ());
      along_normal.at<float>(v, u) =
          static_cast<float>(std::isfinite(n) ? std::min(0.0, layer - n) : 0.0);
      along_z.at<float>(v, u) = static_cast<float>(
          std::isfinite(z) ? std::min(0.0, layer / local->cos_incline - z) : 0.0);
    }
  const cv::Mat found = turned(along_normal, plane.shape);
  double worst = 0, scaled_worst = 0;
  int raised = 0;
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u) {
      const double truth = static_cast<double>(along_z.at<float>(v, u));
      if (!(truth < 0.0)) continue;
      ++raised;
      worst = std::max(worst, std::abs(static_cast<double>(found.at<float>(v, u)) - truth));
      const double scaled =
          static_cast<double>(along_normal.at<float>(v, u)) * std::hypot(1.0, plane.m);
      scaled_worst = std::max(scaled_worst, std::abs(scaled - truth));
    }
  EXPECT_GT(raised, 1000);
  EXPECT_LT(worst, 0.02);
  EXPECT_GT(scaled_worst, 0.05);  // what is wrong without looking elsewhere
}

TEST(DepthAlongZ, AMarkMovesWithTheDepth) {
  const InclinedPlane plane;
  cv::Mat depth = cv::Mat::zeros(540, 960, CV_32FC1), flags = cv::Mat::zeros(540, 960, CV_8UC1);
  const cv::Rect at_limit(450, 240, 60, 60);
  depth(at_limit) = 1.5;
  flags(at_limit) = static_cast<double>(kBeyondLayer);
  const cv::Mat found = depth_along_z(depth, depth_cells(depth), plane.shape, flags);
  int deep = 0;
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u)
      // Cut at the limit without a mark: nowhere.
      if (found.at<float>(v, u) > 1.45F * std::hypot(1.0, plane.m)) {
        EXPECT_EQ(flags.at<std::uint8_t>(v, u), kBeyondLayer) << u << ' ' << v;
        ++deep;
      }
  EXPECT_GT(deep, 1000);
}

/// Where a twisted face is read as touched it is as deep as it is, whichever side of the middle.
TEST(DepthAlongZ, IsThatOfTheSameBallOnATwistedFace) {
  const InclinedPlane straight;
  const double layer = 1.5, radius = 4.0, pressed = 0.8;
  constexpr float kEverywhere = 0.03F;
  for (const double twist : {-0.16, 0.1}) {
    FaceTwist twisted;
    twisted.coefficients = {twist, 0.0, 0.0};
    const auto shape = straight.shape.twisted(twisted);
    ASSERT_TRUE(shape);
    const auto middle = shape->at(520.0, 330.0);
    ASSERT_TRUE(middle);
    const Eigen::Vector3d centre =
        middle->view_point_mm + (layer - pressed + radius) * middle->normal;
    cv::Mat along_normal(540, 960, CV_32FC1, cv::Scalar(NAN)), along_z = along_normal.clone();
    for (int v = 0; v < 540; ++v)
      for (int u = 0; u < 960; ++u) {
        const auto local = shape->at(u, v);
        const auto& column = shape->columns()[static_cast<std::size_t>(u)];
        if (!local || v < column.upper_v || v > column.lower_v) continue;
        const double n = ball_at(local->view_point_mm, local->normal, centre, radius);
        const double z = ball_at(local->view_point_mm, Eigen::Vector3d::UnitZ(), centre, radius);
        const double depth_n = std::isfinite(n) ? layer - n : 0.0,
                     depth_z = std::isfinite(z) ? layer / local->cos_incline - z : 0.0;
        along_normal.at<float>(v, u) = std::max(kEverywhere, static_cast<float>(depth_n));
        along_z.at<float>(v, u) = std::max(kEverywhere / static_cast<float>(local->cos_incline),
                                           static_cast<float>(depth_z));
      }
    const cv::Mat found = turned(along_normal, *shape);
    double worst = 0;
    int compared = 0;
    for (int v = 0; v < 540; ++v)
      for (int u = 0; u < 960; ++u) {
        const float off = found.at<float>(v, u) - along_z.at<float>(v, u);
        if (!std::isfinite(off)) continue;
        worst = std::max(worst, std::abs(static_cast<double>(off)));
        ++compared;
      }
    EXPECT_GT(compared, 100000) << twist;
    EXPECT_LT(worst, 0.03) << twist;
  }
}

TEST(DepthAlongZ, LeavesUntouchedAndUnmeasuredAlone) {
  const InclinedPlane plane;
  cv::Mat depth = cv::Mat::zeros(540, 960, CV_32FC1);
  depth(cv::Rect(400, 200, 30, 30)) = NAN;
  const cv::Mat found = turned(depth, plane.shape);
  for (int v = 0; v < 540; ++v)
    for (int u = 0; u < 960; ++u)
      ASSERT_EQ(std::isnan(found.at<float>(v, u)), std::isnan(depth.at<float>(v, u)));
  double low = 0, high = 0;
  cv::patchNaNs(depth = found.clone(), 0.0);
  cv::minMaxLoc(depth, &low, &high);
  EXPECT_EQ(low, 0.0);
  EXPECT_EQ(high, 0.0);
}

}  // namespace
}  // namespace alltact
