// Laws of the calibration: without noise the truth, in other units and mirrored the same.
#include "calibration/joint/calibrate.h"
#include "tests/support/made_press.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using made::Ball;
using made::Contact;
using made::flat_scene;
using made::Layer;
using made::MadeScene;

struct ScaledWorld {
  MadeScene scene;
  std::vector<Press> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  double radius_mm;
};

/// Four presses of a ball of four `unit_mm` on a flat sensor; all lengths in that unit.
ScaledWorld world(const Layer& layer, double noise, unsigned seed, double unit_mm = 1.0) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  MadeScene scene = flat_scene(0.05 * unit_mm);
  scene.face.layer_mm = 1.5 * unit_mm;
  scene.face.plane_z_mm = 20.0 * unit_mm;
  scene.shape = FaceShape::plane(scene.camera, scene.face);
  ScaledWorld made{scene, {}, {}, 4.0 * unit_mm};
  Layer scaled = layer;
  scaled.thickness_mm *= unit_mm;
  for (int i = 0; i < 4; ++i) {
    Ball ball{120.0 + 160.0 * uniform(random), 100.0 + 100.0 * uniform(random)};
    ball.radius_mm = made.radius_mm;
    ball.depth_mm = (0.4 + 0.25 * i + 0.1 * uniform(random)) * unit_mm;
    auto one = make_press(scene, scaled, Contact{}, {ball}, noise, random, fmt::format("p{}", i));
    made.presses.push_back(std::move(one.press));
    made.centres_mm.push_back(one.centre_mm);
  }
  return made;
}

Calibration calibrated(const ScaledWorld& w) {
  CalibrationSettings settings;
  settings.family = FamilyChoice::kMoebius;
  settings.along = AlongChoice::kZ;
  auto result = calibrate(w.presses, w.scene.camera, w.scene.face, settings, Job{});
  EXPECT_TRUE(result.ok()) << (result ? "" : result.error().sentence());
  return result ? std::move(result).value() : Calibration{};
}

/// Greatest difference of a mapping from k times another one, mm, as far as both are calibrated.
double difference_mm(const MappingParameters& a, const MappingParameters& b, double k = 1.0) {
  const Mapping one = Mapping::create(a).value(), other = Mapping::create(b).value();
  double worst = 0;
  for (int i = 0; i <= 100; ++i) {
    const double x = std::min(a.x_max, b.x_max) * i / 100.0;
    worst = std::max(worst, std::abs(one.depth_mm(x) - k * other.depth_mm(x)));
  }
  return worst;
}

// Samples are means over blocks of 0.2 mm of what is curved: that leaves 0.002 mm.
constexpr double kBlocksMm = 0.003;

TEST(CalibrationLaws, WithoutNoiseTheTruthComesBack) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    // Without absorption the mapping is d = t (1 + s) x / (1 + s x) exactly.
    const Layer layer{0.3 + 0.25 * seed, 0.0};
    const ScaledWorld w = world(layer, 0.0, 100 + seed);
    const Calibration found = calibrated(w);
    ASSERT_EQ(found.balls.size(), 4U);
    MappingParameters truth = found.mapping;
    truth.a_mm = 1.5 * (1.0 + layer.s), truth.b = layer.s;
    EXPECT_LT(difference_mm(found.mapping, truth), kBlocksMm) << layer.s;
    for (std::size_t i = 0; i < 4; ++i)
      EXPECT_LT((found.balls[i].centre_mm - w.centres_mm[i]).norm(), kBlocksMm) << layer.s;
  }
}

TEST(CalibrationLaws, AWorldKTimesAsLargeHasAMappingKTimesAsDeep) {
  const ScaledWorld one = world({0.7, 0.02}, 1.0, 201);
  const Calibration mm = calibrated(one);
  for (const double k : {0.5, 0.8, 1.5, 2.0}) {
    const ScaledWorld other = world({0.7, 0.02}, 1.0, 201, k);
    const Calibration scaled = calibrated(other);
    ASSERT_EQ(scaled.balls.size(), mm.balls.size());
    // Samples are weighed with a floor of 0.003 mm, which does not scale.
    EXPECT_LT(difference_mm(scaled.mapping, mm.mapping, k), 0.004 * k) << k;
    for (std::size_t i = 0; i < mm.balls.size(); ++i)
      EXPECT_LT((scaled.balls[i].centre_mm - k * mm.balls[i].centre_mm).norm(), 0.004 * k) << k;
  }
}

TEST(CalibrationLaws, MirroredPressesGiveTheSameMappingAndMirroredBalls) {
  const ScaledWorld one = world({0.7, 0.02}, 1.0, 301);
  const Calibration straight = calibrated(one);
  for (const int how : {0, 1}) {
    ScaledWorld mirrored = one;
    const CameraParameters& lens = one.scene.camera.parameters();
    CameraParameters p = lens;
    (how == 1 ? p.cx_px : p.cy_px) =
        how == 1 ? p.width_px - 1 - p.cx_px : p.height_px - 1 - p.cy_px;
    mirrored.scene.camera = Camera::create(p).value();
    mirrored.scene.shape = FaceShape::plane(mirrored.scene.camera, mirrored.scene.face);
    for (Press& press : mirrored.presses) {
      cv::Mat x, flags;
      cv::flip(press.difference.x, x, how);
      cv::flip(press.difference.flags, flags, how);
      press.difference.x = x, press.difference.flags = flags;
      press.shape = mirrored.scene.shape;
    }
    const Calibration found = calibrated(mirrored);
    ASSERT_EQ(found.balls.size(), straight.balls.size());
    // Blocks of pixels are laid from the other corner, and hold other noise.
    EXPECT_LT(difference_mm(found.mapping, straight.mapping), 0.004);
    for (std::size_t i = 0; i < found.balls.size(); ++i) {
      Eigen::Vector3d centre = found.balls[i].centre_mm;
      centre[how == 1 ? 0 : 1] *= -1;
      EXPECT_LT((centre - straight.balls[i].centre_mm).norm(), 0.004) << how;
    }
  }
}

}  // namespace
}  // namespace alltact
