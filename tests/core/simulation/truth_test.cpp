// The truth against geometry computed here, in long double and by other means.
#include "core/camera/camera.h"
#include "tests/core/simulation/scene_text.h"

#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using Real = long double;

struct Pose {
  Real q1, q2, sway;
};

struct CurvePoint {
  Real s, x, z, theta, shift;
};

// The bent middle line by a fine midpoint rule.
std::vector<CurvePoint> bent(const Pose& pose) {
  constexpr int kSteps = 40000;
  constexpr Real kLength = 116, kIncline = 34 * std::numbers::pi_v<Real> / 180;
  const auto theta = [&](Real s) {
    const Real t = s / kLength;
    return kIncline + (2 * pose.q1 * t + pose.q2 * (3 * t * t - 2 * t)) / kLength;
  };
  const Real h = kLength / kSteps;
  std::vector<CurvePoint> points{{0, -25, 28, theta(0), 0}};
  for (int i = 0; i < kSteps; ++i) {
    CurvePoint p = points.back();
    const Real middle = theta(p.s + h / 2);
    p.x += h * std::cos(middle);
    p.z += h * std::sin(middle);
    p.s += h;
    p.theta = theta(p.s);
    p.shift = pose.sway * (p.s / kLength) * (p.s / kLength);
    points.push_back(p);
  }
  return points;
}

// Where column u's rays cross it.
CurvePoint cross(const std::vector<CurvePoint>& curve, Real direction) {
  for (std::size_t i = 1; i < curve.size(); ++i) {
    const Real a = curve[i - 1].x - direction * curve[i - 1].z;
    const Real b = curve[i].x - direction * curve[i].z;
    if (a > 0 || b < 0) continue;
    const Real t = a / (a - b);
    const auto mix = [&](Real f, Real g) { return f + t * (g - f); };
    return {mix(curve[i - 1].s, curve[i].s), mix(curve[i - 1].x, curve[i].x),
            mix(curve[i - 1].z, curve[i].z), mix(curve[i - 1].theta, curve[i].theta),
            mix(curve[i - 1].shift, curve[i].shift)};
  }
  return {-1, 0, 0, 0, 0};
}

std::string text_of(const Pose& pose, const std::string& effects, const std::string& camera = "") {
  return fmt::format("motion: {{kind: hold, pose: {{q1_mm: {}, q2_mm: {}, sway_mm: {}}}}}\n",
                     static_cast<double>(pose.q1), static_cast<double>(pose.q2),
                     static_cast<double>(pose.sway)) +
         scene_text(
             "  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -6, to: 6}}\n"
             "  - {use: sway, sway_mm: {from: -4, to: 4}}\n" +
                 effects,
             camera);
}

std::vector<Pose> random_poses(int n) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1, 1);
  std::vector<Pose> poses;
  for (int i = 0; i < n; ++i)
    poses.push_back({5 * unit(random), 5 * unit(random), 3 * unit(random)});
  return poses;
}

TEST(Truth, FaceIsWhereTheRaysMeetTheBentSurface) {
  for (const Pose& pose : random_poses(4)) {
    const Truth truth = plan_of(text_of(pose, "")).truth(0);
    const auto curve = bent(pose);
    for (int u = 8; u < 320; u += 7) {
      const CurvePoint p = cross(curve, (u - 158.5L) / 170);
      for (int v = 0; v < 180; v += 3) {
        const Real y = (v - 90.25L) / 172 * p.z - p.shift;
        const Real to_edge = (12 - std::abs(y)) * 172 / p.z;  // px
        if (std::abs(to_edge) < 1e-3L || (p.s > 0 && (p.s < 0.5L || p.s > 115.0L))) continue;
        const float z = truth.view_z_mm.at<float>(v, u);
        if (p.s < 0 || to_edge < 0) {
          EXPECT_TRUE(std::isnan(z)) << u << ' ' << v;
          EXPECT_TRUE(std::isnan(truth.depth_mm.at<float>(v, u)));
        } else {
          EXPECT_NEAR(z, p.z, 2e-5);
          EXPECT_NEAR(truth.untouched_z_mm.at<float>(v, u), p.z + 1.5L / std::cos(p.theta), 3e-5);
          EXPECT_EQ(truth.depth_mm.at<float>(v, u), 0.0F);
        }
      }
    }
  }
}

// Brightness 1 on the face and 0 beside it: a column's sum is the face's length in it.
TEST(Render, EdgesLieWhereTheWidthSays) {
  for (const Pose& pose : random_poses(3)) {
    const cv::Mat image = plan_of(text_of(pose, "")).render(0);
    const auto curve = bent(pose);
    for (int u = 12; u < 260; u += 5) {
      const CurvePoint p = cross(curve, (u - 158.5L) / 170);
      Real length = 0, moment = 0;
      for (int v = 0; v < 180; ++v) {
        length += image.at<float>(v, u);
        moment += v * Real{image.at<float>(v, u)};
      }
      EXPECT_NEAR(length, 172 * 24 / p.z, 2e-4);
      // The middle follows the sway; what partly covered pixels add to it is below 0.01 px.
      EXPECT_NEAR(moment / length, 90.25L + 172 * p.shift / p.z, 0.01);
    }
  }
}

TEST(Truth, BallIsTheBallThatIsPressed) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const Pose& pose : random_poses(5)) {
    const double radius = 3 + 3 * unit(random), s = 20 + 40 * unit(random),
                 y = 8 * unit(random) - 4;
    const double depth = 0.3 + unit(random);
    const Truth truth =
        plan_of(text_of(pose,
                        fmt::format(
                            "  - {{use: ball, radius_mm: {}, s_mm: {}, y_mm: {}, depth_mm: {}}}\n",
                            radius, s, y, depth)))
            .truth(0);
    ASSERT_TRUE(truth.ball);
    // A ray along z through each face point, against the sphere.
    const Eigen::Vector3d c = truth.ball->centre_mm;
    double deepest = 0;
    int inside = 0;
    for (int v = 0; v < 180; ++v)
      for (int u = 0; u < 320; ++u) {
        const double z = truth.view_z_mm.at<float>(v, u);
        if (std::isnan(z)) continue;
        const double dx = (u - 158.5) / 170 * z - c.x(), dy = (v - 90.25) / 172 * z - c.y();
        const double h2 = radius * radius - dx * dx - dy * dy;
        const double free = truth.untouched_z_mm.at<float>(v, u);
        const double pressed = h2 > 0 ? std::max(0.0, free - (c.z() - std::sqrt(h2))) : 0.0;
        // Near the rim of the contact the sphere falls away steeply on an inclined face.
        EXPECT_NEAR(truth.depth_mm.at<float>(v, u), pressed, 1e-4) << u << ' ' << v;
        deepest = std::max(deepest, pressed);
        inside += pressed > 0;
      }
    EXPECT_GT(inside, 50);
    EXPECT_LE(deepest, depth + 1e-5);
    EXPECT_GT(deepest, depth - 0.05);
  }
}

// On a flat face Hertz can be checked by itself.
TEST(Truth, RolloffMeetsTheBallAndFallsOffLikeHertz) {
  const std::string flat =
      "name: flat\nwhy: a flat sensor to test with\nfinger:\n"
      "  camera: {model: orthographic, size: [400, 300], mm_per_px: 0.04, cx: 199.5, cy: 149.5}\n"
      "  face: {kind: flat, layer_mm: 1.5, plane_z_mm: 30}\neffects:\n"
      "  - {use: ball, radius_mm: 4, s_mm: 0.02, y_mm: 0.02, depth_mm: 0.8}\n"
      "  - {use: rolloff, kind: hertz}\n";
  const Truth truth = plan_of(flat).truth(0);
  const Real a = std::sqrt(4 * 0.8L), at_rim = 0.8L - (4 - std::sqrt(16 - a * a));
  for (int u = 200; u < 400; ++u) {
    const Real r = (u - 200) * 0.04L;  // along the row through the deepest point
    const float d = truth.depth_mm.at<float>(150, u);
    if (r < a)
      EXPECT_NEAR(d, 0.8L - (4 - std::sqrt(16 - r * r)), 2e-6);
    else
      EXPECT_NEAR(
          d,
          at_rim * 2 / std::numbers::pi_v<Real> *
              ((2 - r * r / (a * a)) * std::asin(a / r) + std::sqrt(r * r / (a * a) - 1)),
          // The profile is tabulated every 0.005 mm; just outside the rim it bends like a root.
          r < a + 0.05L ? 1e-4 : 2e-6);
  }
}

TEST(Truth, BulgeThickensTheLayerAroundAPress) {
  const Truth truth =
      plan_of(scene_text("  - {use: ball, radius_mm: 4, s_mm: 40, y_mm: 0, depth_mm: 1}\n"
                         "  - {use: bulge, share: 0.1, width_mm: 1.5}\n"))
          .truth(0);
  double least = 0;
  cv::minMaxLoc(truth.depth_mm, &least, nullptr, nullptr, nullptr,
                truth.depth_mm == truth.depth_mm);
  // Highest one width from the rim: 0.1 of the layer along its normal, more along z.
  EXPECT_NEAR(least, -0.15 / std::cos(34 * std::numbers::pi / 180), 0.003);
}

TEST(Truth, MarkersAreTheImagesOfTheDots) {
  const std::string effects =
      "  - {use: markers, radius_mm: 1.5, setback_mm: 5, first: 0.1, last: 0.9, albedo: 1}\n"
      "  - {use: sides, albedo: 0.001, depth_mm: 14}\n";
  const Real f = 1020;
  for (const Pose& pose : random_poses(3)) {
    const Plan plan = plan_of(text_of(
        pose, effects, "model: pinhole, size: [1920, 1080], fx: 1020, fy: 1020, cx: 951, cy: 539"));
    const Truth truth = plan.truth(0);
    const cv::Mat image = plan.render(0, 2);
    const auto curve = bent(pose);
    ASSERT_EQ(truth.markers.size(), 12U);
    for (int i = 0; i < 12; ++i) {
      const auto& dot = truth.markers[static_cast<std::size_t>(i)];
      ASSERT_TRUE(dot.visible);
      const auto& p = curve[static_cast<std::size_t>(std::lround((0.1 + 0.16 * (i % 6)) * 40000))];
      const Real z = p.z - 5 * std::cos(p.theta), x = p.x + 5 * std::sin(p.theta);
      const Real y = p.shift + (i < 6 ? -12 : 12);
      // The middle of a circle's image is the image of a point up to r^2 / z nearer.
      EXPECT_NEAR(dot.u, 951 + f * x / z, f * 2.25 * std::abs(x) / (z * z * z) + 0.5);
      EXPECT_NEAR(dot.v, 539 + f * y / z, f * 2.25 * std::abs(y) / (z * z * z) + 0.01);
      // The drawn dot's centre of brightness and its area: that of the circle, seen in its plane.
      const auto reach_u = static_cast<int>(1.3 * f * 1.5 / z * (1 + std::abs(x) / z) + 2);
      const auto reach_v = static_cast<int>(1.3 * f * 1.5 * 12 / (z * z) + 2);
      Real sum = 0, sum_u = 0, sum_v = 0;
      for (int v = std::max(0, static_cast<int>(dot.v) - reach_v);
           v <= std::min(1079, static_cast<int>(dot.v) + reach_v); ++v)
        for (int u = std::max(0, static_cast<int>(dot.u) - reach_u);
             u <= std::min(1919, static_cast<int>(dot.u) + reach_u); ++u) {
          const Real value = (image.at<float>(v, u) - 0.001L) / 0.999L;
          if (value <= 0) continue;
          sum += value;
          sum_u += u * value;
          sum_v += v * value;
        }
      EXPECT_NEAR(sum_u / sum, dot.u, 0.05) << i;
      EXPECT_NEAR(sum_v / sum, dot.v, 0.05) << i;
      const Real area = std::numbers::pi_v<Real> * 2.25L * f * f * std::abs(y) / (z * z * z);
      EXPECT_NEAR(sum / area, 1, 0.03);
    }
  }
}

// A camera with distortion sees the same finger: its rays, the same surface.
TEST(Truth, HoldsForACameraWithDistortion) {
  const std::string camera =
      "model: brown, size: [320, 180], fx: 200, fy: 201, cx: 158.5, cy: 90.25";
  const Pose pose{3, -2, 1.5L};
  const Plan plan = plan_of(text_of(
      pose, "  - {use: distortion, coefficients: [-0.12, 0.02, 0.001, -0.0005, 0.0]}\n", camera));
  const Truth truth = plan.truth(0);
  const auto lens = Camera::create(plan.finger().camera);
  ASSERT_TRUE(lens);
  const auto curve = bent(pose);
  int compared = 0;
  for (int v = 2; v < 180; v += 11)
    for (int u = 12; u < 320; u += 13) {
      const auto ray = lens->unproject({static_cast<double>(u), static_cast<double>(v)});
      ASSERT_TRUE(ray);
      const CurvePoint p = cross(curve, ray->direction.x());
      const Real inside = 12 - std::abs(ray->direction.y() * p.z - p.shift);
      if (p.s < 0.5L || p.s > 115 || std::abs(inside) < 0.02L) continue;
      const float z = truth.view_z_mm.at<float>(v, u);
      ASSERT_EQ(std::isnan(z), inside < 0) << u << ' ' << v;
      if (inside < 0) continue;
      EXPECT_NEAR(z, p.z, 5e-5);
      ++compared;
    }
  EXPECT_GT(compared, 100);
}

}  // namespace
}  // namespace alltact
