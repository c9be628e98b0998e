// Balls pressed into an inclined face, traced ray by ray: where part of the ball hides another, and
// what that tells.
#include "calibration/joint/calibrate.h"
#include "calibration/joint/joint_costs.h"
#include "calibration/joint/outline_methods.h"
#include "core/geometry/ball.h"
#include "core/numerics/median.h"
#include "tests/support/made_press.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

using namespace made;

constexpr double kRadiusMm = 3.0;

/// What one line of sight goes through: from the view face into the layer, to the ball or, past it,
/// to the outer side. Skin follows the ball to the rim of its cap.
struct Sight {
  double thickness_mm = 0;  ///< of the layer on this line
  bool ball = false;
};

class RayTracer {
 public:
  /// The contact's middle is the outer side's point over pixel (u, v).
  RayTracer(const MadeScene& scene, double u, double v, double depth_mm) : scene_(scene) {
    foot_mm_ = scene.shape.at(u, v)->view_point_mm + scene.face.layer_mm * scene.normal;
    centre_mm_ = foot_mm_ + (kRadiusMm - depth_mm) * scene.normal;
  }
  [[nodiscard]] const Eigen::Vector3d& centre_mm() const { return centre_mm_; }

  [[nodiscard]] Sight along(const Eigen::Vector3d& from, const Eigen::Vector3d& unit) const {
    const double to_outside = (foot_mm_ - from).dot(scene_.normal) / unit.dot(scene_.normal);
    const double ahead = (centre_mm_ - from).dot(unit);
    const double aside2 = (centre_mm_ - from - ahead * unit).squaredNorm();
    if (aside2 < kRadiusMm * kRadiusMm) {
      const double to_ball = ahead - std::sqrt(kRadiusMm * kRadiusMm - aside2);
      if (to_ball < to_outside) return {to_ball, true};
    }
    return {to_outside, false};
  }

 private:
  const MadeScene& scene_;
  Eigen::Vector3d foot_mm_, centre_mm_;
};

/// Degrees of the ball's horizon that hide something, by brute force: sight just inside the horizon
/// ends on the ball, just outside it passes and goes on for a while.
double traced_arc_deg(const MadeScene& scene, const RayTracer& tracer) {
  constexpr int kCount = 3600;
  int hiding = 0;
  for (const Eigen::Vector3d& p : ball_horizon_mm(true, tracer.centre_mm(), kRadiusMm, kCount)) {
    const auto trace = [&](double scale) {
      const Eigen::Vector3d unit =
          (tracer.centre_mm() + scale * (p - tracer.centre_mm())).normalized();
      const auto pixel = scene.camera.project(unit);
      const auto local = scene.shape.at(pixel->x(), pixel->y());
      return tracer.along(local->view_point_mm, unit);
    };
    const Sight inside = trace(0.999999), outside = trace(1.000001);
    hiding +=
        inside.ball && !outside.ball &&
        (outside.thickness_mm - inside.thickness_mm) * p.normalized().dot(scene.normal) > 0.05;
  }
  return 360.0 * hiding / kCount;
}

/// A press as the camera sees it: brightness follows the layer's thickness on the line of sight (or
/// along z), measured in parts of what it is there untouched.
Press traced_press(const MadeScene& scene, const RayTracer& tracer, const Layer& layer,
                   bool along_z, double noise, std::mt19937& random) {
  const cv::Size size = scene.camera.size();
  std::normal_distribution<double> normal;
  cv::Mat x(size, CV_32FC1, cv::Scalar(NAN));
  cv::Mat grain(size, CV_32FC1);
  for (int v = 0; v < size.height; ++v) {
    for (int u = 0; u < size.width; ++u) {
      grain.at<float>(v, u) = static_cast<float>(normal(random));
      const auto rows = scene.shape.rows(u, 2.0);
      if (v < rows.first || v > rows.last) continue;
      // A pixel is an area: the mean over it.
      double sum = 0;
      for (const double du : {-0.375, -0.125, 0.125, 0.375})
        for (const double dv : {-0.375, -0.125, 0.125, 0.375}) {
          const auto local = scene.shape.at(std::clamp(u + du, 0.0, size.width - 1.0), v + dv);
          if (!local) continue;
          const Eigen::Vector3d unit =
              along_z ? Eigen::Vector3d::UnitZ() : local->view_point_mm.normalized();
          const Sight sight = tracer.along(local->view_point_mm, unit);
          const double left = sight.thickness_mm * unit.dot(scene.normal);
          sum += layer.difference_at(scene.face.layer_mm - left) / 16.0;
        }
      x.at<float>(v, u) = static_cast<float>(sum);
    }
  }
  cv::Mat blurred;
  cv::Mat filled = x.clone();
  cv::patchNaNs(filled, 0.0);
  cv::GaussianBlur(filled, blurred, {9, 9}, 1.0);
  blurred.setTo(NAN, x != x);
  return {"traced", noisy_difference(blurred, grain, noise), scene.shape, kRadiusMm};
}

/// 2 acos((1 - h/R) / cos b) with b the angle between sight and face, for a distant camera.
double formula_arc_deg(double depth_mm, double face_to_sight_deg) {
  const double ratio = (1.0 - depth_mm / kRadiusMm) / std::cos(face_to_sight_deg * M_PI / 180.0);
  return ratio < 1.0 ? 2.0 * std::acos(ratio) * 180.0 / M_PI : 0.0;
}

TEST(TangentArc, TheHidingHorizonIsWhatRaysFind) {
  for (const double incline : {35.0, 50.0, 60.0, 68.0}) {
    const MadeScene scene = finger_scene(60.0, incline);
    for (const double depth : {0.3, 0.6, 1.0, 1.3}) {
      const RayTracer tracer(scene, 479.5, 269.5, depth);
      const auto hiding = occluding_horizon(scene.shape, tracer.centre_mm(), kRadiusMm, 0.1);
      const double arc_deg = 0.1 * static_cast<double>(hiding.size());
      EXPECT_NEAR(arc_deg, traced_arc_deg(scene, tracer), 2.5)
          << "incline " << incline << ", depth " << depth;
      // The formula is for parallel sight; at its limit, where arcs begin, little makes much.
      const double formula = formula_arc_deg(depth - 0.05, 90.0 - incline);
      if (formula > 40.0) {
        EXPECT_NEAR(arc_deg, formula, 8.0) << "incline " << incline << ", depth " << depth;
      }
    }
  }
}

TEST(TangentArc, NoneWhereTheFaceIsSeenSteeplyFromAbove) {
  const MadeScene flat = flat_scene();
  EXPECT_TRUE(occluding_horizon(flat.shape, {10.0, 7.0, 23.0}, kRadiusMm, 1.0).empty());
  const MadeScene scene = finger_scene(60.0, 34.0);  // b = 56 degrees: 1 - h/R must be below 0.56
  for (const double depth : {0.3, 0.8, 1.2})
    EXPECT_TRUE(occluding_horizon(scene.shape, RayTracer(scene, 479.5, 269.5, depth).centre_mm(),
                                  kRadiusMm, 1.0)
                    .empty())
        << depth;
}

TEST(TangentArc, JumpsAreFoundToAPartOfAPixel) {
  std::mt19937 random(41);
  const MadeScene scene = finger_scene(60.0, 60.0);
  for (const double depth : {0.7, 1.2}) {
    const RayTracer tracer(scene, 479.5, 269.5, depth);
    const Press press = traced_press(scene, tracer, {}, false, 1.0, random);
    // Looked for where a fit by brightness alone would put the ball, a tenth of a millimetre off.
    const Eigen::Vector3d near = tracer.centre_mm() + Eigen::Vector3d(0.08, -0.05, 0.1);
    const TangentArc arc = find_tangent_arc(press, near, kRadiusMm);
    // It is looked for every 8 degrees.
    EXPECT_NEAR(arc.arc_deg, traced_arc_deg(scene, tracer), 8.0) << depth;
    ASSERT_GT(arc.arc_deg, 20.0) << depth;
    const double px = 60.0 / scene.camera.parameters().fx_px;  // mm of a pixel there
    std::vector<double> off_px, sizes_px;
    double mean = 0;
    for (const OutlinePoint& point : arc.points) {
      off_px.push_back(outline_angle_rad(point.direction, tracer.centre_mm(), kRadiusMm) * 60.0 /
                       px);
      sizes_px.push_back(std::abs(off_px.back()));
      mean += off_px.back() / static_cast<double>(arc.points.size());
    }
    // At the arc's ends, where the jump ends, single points may be a pixel off: the fit is robust.
    const double middle = upper_median(sizes_px);
    const double worst = *std::max_element(sizes_px.begin(), sizes_px.end());
    std::printf("depth %.1f: %.0f degrees, median %.2f px, worst %.2f px, mean %+.2f px\n", depth,
                arc.arc_deg, middle, worst, mean);
    EXPECT_LT(middle, 0.15) << depth;
    EXPECT_LT(worst, 1.5) << depth;
    EXPECT_LT(std::abs(mean), 0.35) << depth;
  }
}

TEST(TangentArc, AFadingBorderIsNoOutline) {
  std::mt19937 random(42);
  // No part of the ball hides another at 34 degrees; at 60 the same place is looked at in a picture
  // in which it does not either, because skin leaves the ball softly.
  const MadeScene gentle = finger_scene(60.0, 34.0);
  const RayTracer tracer(gentle, 520, 269.5, 1.0);
  const Press press = traced_press(gentle, tracer, {}, false, 1.0, random);
  EXPECT_EQ(find_tangent_arc(press, tracer.centre_mm(), kRadiusMm).arc_deg, 0.0);

  const MadeScene steep = finger_scene(60.0, 60.0);
  for (const Contact contact : {Contact{Skin::kHertz, 0, 0.02}, Contact{Skin::kSmooth, 0.3, 0}}) {
    const Made soft =
        make_press(steep, {}, contact, {{479.5, 269.5, kRadiusMm, 0.45}}, 1.0, random);
    EXPECT_EQ(find_tangent_arc(soft.press, soft.centre_mm, kRadiusMm).arc_deg, 0.0);
  }
}

TEST(TangentArc, EveryCostAgreesWithDifferences) {
  std::mt19937 random(43);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int round = 0; round < 20; ++round) {
    const double depth = 44.0 + 20.0 * uniform(random);
    std::vector<Sample> samples(12);
    std::vector<OutlinePoint> outline(7);
    WeightedPress weighted;
    for (Sample& sample : samples) {
      sample.normal = Eigen::Vector3d(0.5 * uniform(random), 0.0, 1.0).normalized();
      sample.untouched_n = {uniform(random), uniform(random), depth - 3.0};
      sample.untouched_z = sample.untouched_n + Eigen::Vector3d(0.0, 0.0, 0.1);
      sample.x = 0.3 + 0.29 * uniform(random);
      weighted.samples.push_back(&sample);
      weighted.blur_mm.push_back(0.01 * uniform(random));
      weighted.slope_mm.push_back(1.0 + 0.5 * uniform(random));
      weighted.root_weight.push_back(1.0 + std::abs(uniform(random)));
    }
    for (OutlinePoint& point : outline) {
      point.direction = {0.1 * uniform(random), 0.1 * uniform(random), 1.0};
      weighted.outline.push_back(&point);
      weighted.outline_root_weight.push_back(1.0 + std::abs(uniform(random)));
    }
    const Eigen::Vector3d centre(0.3 * uniform(random), 0.3 * uniform(random), depth);
    weighted.ball_radius_mm = 4.0;
    weighted.plane = {{0.0, 0.0, depth - 3.0}, Eigen::Vector3d::UnitZ()};
    const OutlineCost outlines(weighted);
    for (const MappingAlong along : {MappingAlong::kZ, MappingAlong::kNormal})
      for (const CurveFamily family :
           {CurveFamily{MappingKind::kMoebius, 2}, CurveFamily{MappingKind::kMoebius, 3},
            CurveFamily{MappingKind::kPolynomial, 4}}) {
        MappingCurve curve(family, 0.6);
        for (double& value : curve.values()) value = 0.3 + 0.1 * uniform(random);
        curve.values()[0] += 2.7;  // so that it rises as far as the ball is deep
        JointOptions options;
        options.along = along;
        const PressCost brightness(weighted, curve, options, round % 3 != 0);
        for (const ceres::CostFunction* cost :
             {static_cast<const ceres::CostFunction*>(&brightness),
              static_cast<const ceres::CostFunction*>(&outlines)}) {
          std::vector<std::vector<double>> blocks{{centre.x(), centre.y(), centre.z()}};
          if (cost == &brightness) {
            blocks.emplace_back(curve.values().begin(), curve.values().end());
            blocks.push_back({std::log(0.3)});
          }
          const auto evaluate = [&](std::vector<std::vector<double>> at, double** jacobians) {
            std::vector<const double*> pointers;
            for (const auto& block : at) pointers.push_back(block.data());
            std::vector<double> residuals(static_cast<std::size_t>(cost->num_residuals()));
            EXPECT_TRUE(cost->Evaluate(pointers.data(), residuals.data(), jacobians));
            return residuals;
          };
          std::vector<std::vector<double>> slopes;
          std::vector<double*> pointers;
          for (const auto& block : blocks)
            slopes.emplace_back(block.size() * static_cast<std::size_t>(cost->num_residuals()));
          for (auto& slope : slopes) pointers.push_back(slope.data());
          (void)evaluate(blocks, pointers.data());
          for (std::size_t b = 0; b < blocks.size(); ++b)
            for (std::size_t k = 0; k < blocks[b].size(); ++k) {
              constexpr double kStep = 1e-5;
              auto up = blocks, down = blocks;
              up[b][k] += kStep;
              down[b][k] -= kStep;
              const auto high = evaluate(up, nullptr), low = evaluate(down, nullptr);
              for (std::size_t i = 0; i < high.size(); ++i)
                EXPECT_NEAR(slopes[b][i * blocks[b].size() + k], (high[i] - low[i]) / (2.0 * kStep),
                            1e-7)
                    << "block " << b << ", unknown " << k;
            }
        }
      }
  }
}

/// Three presses on a steep face near the optical axis, where sight is nearly along z.
Calibration steep_calibration(bool along_z, std::vector<Eigen::Vector3d>* centres_mm) {
  std::mt19937 random(44);
  const MadeScene scene = finger_scene(60.0, 60.0);
  const Layer layer{0.6, 0.0};
  std::vector<Press> presses;
  for (const double depth : {0.7, 0.95, 1.2}) {
    const RayTracer tracer(scene, 470.0 + 10.0 * depth, 250.0 + 20.0 * depth, depth);
    centres_mm->push_back(tracer.centre_mm());
    presses.push_back(traced_press(scene, tracer, layer, along_z, 1.0, random));
    presses.back().name = std::to_string(depth);
  }
  CalibrationSettings settings;
  settings.along = AlongChoice::kZ;
  return calibrate(presses, scene.camera, scene.face, settings, Job{}).value();
}

TEST(TangentArc, OutlinesJoinTheFitOfSteepPressesAndAreReported) {
  for (const bool along_z : {false, true}) {
    std::vector<Eigen::Vector3d> truth;
    const Calibration calibration = steep_calibration(along_z, &truth);
    ASSERT_EQ(calibration.balls.size(), truth.size());
    EXPECT_LT(calibration.held_out_mm, 0.02);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const BallFit& ball = calibration.balls[i];
      EXPECT_GE(ball.tangent_arc_deg, 30.0);
      const Eigen::Vector3d off = ball.centre_mm - truth[i];
      std::printf("arc %.0f degrees, centre off by (%+.3f %+.3f %+.3f) mm\n", ball.tangent_arc_deg,
                  off.x(), off.y(), off.z());
      // The outline holds the ball across sight. Along it brightness has to, which follows z in one
      // of the two worlds only.
      EXPECT_LT(off.head<2>().norm(), 0.07);
      EXPECT_LT(std::abs(off.z()), along_z ? 0.03 : 0.17);
    }
  }
}

TEST(TangentArc, PressesWithoutAnOutlineReportNone) {
  std::mt19937 random(45);
  const MadeScene scene = finger_scene(40.0, 20.0);
  std::vector<Press> presses;
  for (const double depth : {0.5, 0.8, 1.1})
    presses.push_back(make_press(scene, {}, {}, {{400.0 + 80.0 * depth, 260.0, 4.0, depth}}, 1.0,
                                 random, std::to_string(depth))
                          .press);
  const auto result = calibrate(presses, scene.camera, scene.face, {}, Job{});
  ASSERT_TRUE(result.ok()) << result.error().sentence();
  for (const BallFit& ball : result->balls) EXPECT_EQ(ball.tangent_arc_deg, 0.0);
}

}  // namespace
}  // namespace alltact
