// Presses of which more is known than the image shows: a measured depth, a punch with a step,
// another body of known shape.
#include "calibration/joint/calibrate.h"
#include "calibration/joint/joint_costs.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press_note_kinds.h"
#include "core/mesh/mesh_distance.h"
#include "tests/support/made_meshes.h"
#include "tests/support/made_press.h"
#include "tests/support/slow_run.h"

#include <cstdio>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kNoise = 4.0;
const Layer kLayer{0.6, 0.05};

/// Presses of a ball on flat skin; of the last `told` of them the depth was measured, to `sd_mm`.
std::vector<Press> ball_presses(int told, double sd_mm, std::mt19937& random, int count = 6) {
  const MadeScene scene = flat_scene();
  std::normal_distribution<double> normal;
  std::vector<Press> presses;
  for (int i = 0; i < count; ++i) {
    const double depth_mm = 0.45 + 0.78 * i / count;
    presses.push_back(make_press(scene, kLayer, {Skin::kTail, 0.75},
                                 {Ball{130.0 + 28.0 * i, 110.0 + 16.0 * i, 4.0, depth_mm}}, kNoise,
                                 random, fmt::format("p{}", i))
                          .press);
    if (i >= count - told) presses.back().given_depth = {depth_mm + sd_mm * normal(random), sd_mm};
  }
  return presses;
}

/// What a calibration reads at 0.8 mm, over that, and its standard deviation as the calibration
/// says it; and what it reads between 0.3 and 0.9 mm, over that.
struct Scale {
  double ratio = 0, sd = 0, between = 0;
};
Scale scale_of(const std::vector<Press>& presses) {
  const MadeScene scene = flat_scene();
  const auto done = calibrate(presses, scene.camera, scene.face, {}, Job{});
  EXPECT_TRUE(done.ok()) << (done ? "" : done.error().sentence());
  if (!done) return {};
  for (const Message& reason : done->left_out)
    std::printf("[ figures  ] %s\n", reason.english().c_str());
  const Mapping mapping = Mapping::create(done->mapping).value();
  constexpr double kDepth = 0.8;
  const double x = kLayer.difference_at(kDepth);
  const auto read = [&](double depth_mm) {
    return mapping.depth_mm(kLayer.difference_at(depth_mm));
  };
  return {read(kDepth) / kDepth, mapping.depth_sd_mm(x) / kDepth,
          (read(0.9) - read(0.3)) / (0.9 - 0.3)};
}

struct Spread {
  double error = 0, z2 = 0;  ///< root mean square of ratio - 1; mean squared error over variance
  double between = 0;        ///< root mean square of between - 1
  double sd = 0;             ///< root mean square of what the calibrations say
};
template <class Make>
Spread spread_of(const char* name, const Make& make) {
  const int runs = test::as_many_as(3, 10);
  Spread spread;
  for (int run = 0; run < runs; ++run) {
    std::mt19937 random(100 + run);
    const Scale scale = scale_of(make(random));
    spread.error += std::pow(scale.ratio - 1.0, 2) / runs;
    spread.between += std::pow(scale.between - 1.0, 2) / runs;
    spread.z2 += std::pow((scale.ratio - 1.0) / scale.sd, 2) / runs;
    spread.sd += scale.sd * scale.sd / runs;
  }
  spread.error = std::sqrt(spread.error);
  spread.between = std::sqrt(spread.between);
  spread.sd = std::sqrt(spread.sd);
  std::printf(
      "[ figures  ] %s: off by %.4f rms at 0.8 mm of %.4f promised, z^2 %.2f; by %.4f between 0.3 "
      "and 0.9 mm\n",
      name, spread.error, spread.sd, spread.z2, spread.between);
  return spread;
}

TEST(MeasuredDepth, SettlesTheScale) {
  const auto by_pictures = spread_of(
      "pictures alone", [](std::mt19937& random) { return ball_presses(0, 0.01, random); });
  const auto told = spread_of("three depths +- 0.01 mm",
                              [](std::mt19937& random) { return ball_presses(3, 0.01, random); });
  EXPECT_LT(told.error, 0.6 * by_pictures.error);
  EXPECT_LT(told.error, 0.012);
  EXPECT_LT(told.z2, 2.5);
}

TEST(MeasuredDepth, ThatContradictsThePicturesIsNotUsed) {
  std::mt19937 random(4);
  auto presses = ball_presses(0, 0.01, random);
  presses[4].given_depth = {1.4, 0.01};  // it is 0.97
  const MadeScene scene = flat_scene();
  const auto done = calibrate(presses, scene.camera, scene.face, {}, Job{});
  ASSERT_TRUE(done.ok()) << done.error().sentence();
  EXPECT_THAT(done->left_out,
              testing::Contains(testing::Property(
                  &Message::english, HasSubstr("p4: its measured depth of 1.400 +- 0.010 mm"))));
  EXPECT_NEAR(done->balls[4].indentation_mm, 0.97, 0.03);
}

constexpr int kFewBalls = 3;

std::vector<Press> with_punches(std::mt19937& random) {
  auto presses = ball_presses(0, 0.01, random, kFewBalls);
  std::uniform_real_distribution<double> turn(0.0, 180.0), tilt(-0.015, 0.015);
  for (int i = 0; i < 2; ++i) {
    Punch punch{200, 150};
    punch.step_mm = 0.7;
    punch.depth_mm = 0.95;
    punch.turn_deg = turn(random);
    punch.tilt_first = tilt(random);
    punch.tilt_second = tilt(random);
    presses.push_back(
        make_punch_press(flat_scene(), kLayer, punch, kNoise, random, fmt::format("step{}", i)));
  }
  return presses;
}

// A step tells how far apart two depths are; where the shallower of them lies the balls must tell.
TEST(SteppedPunch, SettlesHowFarApartDepthsAre) {
  const auto by_pictures = spread_of("three balls alone", [](std::mt19937& random) {
    return ball_presses(0, 0.01, random, kFewBalls);
  });
  const auto with = spread_of("with two punches", with_punches);
  EXPECT_LT(with.between, 0.8 * by_pictures.between);
  EXPECT_LT(with.error, 1.2 * by_pictures.error);
  EXPECT_LT(with.z2, 2.5);
}

/// The layer's own curve, through twelve of its points.
MappingCurve curve_of_layer() {
  MappingCurve curve({MappingKind::kPolynomial, 6}, kLayer.difference_at(1.3));
  Eigen::MatrixXd rows(12, 6);
  Eigen::VectorXd depths(12);
  for (int i = 0; i < 12; ++i) {
    const double x = curve.x_max() * (i + 1) / 12;
    Eigen::VectorXd gradient(6);
    (void)curve.depth_mm(x, gradient.data());
    rows.row(i) = gradient.transpose();
    depths[i] = kLayer.depth_at(x);
  }
  curve.values() = rows.colPivHouseholderQr().solve(depths);
  return curve;
}

TEST(SteppedPunch, IsReadByTheMappingOnInclinedFacesToo) {
  for (const double incline : {0.0, 20.0, 35.0}) {
    double sum = 0, most = 0;
    constexpr int kRuns = 6;
    for (unsigned run = 0; run < kRuns; ++run) {
      std::mt19937 random(run);
      const MadeScene scene = finger_scene(80.0, incline);
      std::uniform_real_distribution<double> turn(0.0, 180.0), tilt(-0.03, 0.03);
      Punch punch{480, 300};
      punch.turn_deg = turn(random);
      punch.tilt_first = tilt(random);
      const Press press = make_punch_press(scene, kLayer, punch, 1.0, random, "step");
      const auto step = find_step(press, scene.face);
      ASSERT_TRUE(step.ok()) << incline << ": " << step.error().sentence();
      const MappingCurve curve = curve_of_layer();
      const StepReading reading = read_step(*step, curve, curve.values().data(), MappingAlong::kZ);
      sum += (reading.height_mm - punch.step_mm) / kRuns;
      most = std::max(most, std::abs(reading.height_mm - punch.step_mm) / reading.sd_mm);
    }
    std::printf(
        "[ figures  ] face inclined by %.0f deg: a step of 0.5 mm reads %+.4f mm too high, "
        "at most %.1f sd\n",
        incline, sum, most);
    EXPECT_NEAR(sum, 0.0, 0.006) << incline;
    EXPECT_LT(most, 3.0) << incline;
  }
}

TEST(SteppedPunch, WhatIsNoStepIsRefusedByItsReason) {
  std::mt19937 random(8);
  const MadeScene scene = flat_scene();
  const auto sentence = [&](Press press) {
    press.step_mm = 0.5;
    const auto step = find_step(press, scene.face);
    return step ? std::string("found") : step.error().sentence();
  };
  EXPECT_THAT(sentence(make_press(scene, kLayer, {}, {}, 1.0, random).press),
              HasSubstr("touches too little"));
  Punch flat{200, 150};
  flat.step_mm = 0.0;
  EXPECT_THAT(sentence(make_punch_press(scene, kLayer, flat, 1.0, random, "flat")),
              HasSubstr("no step is visible"));
  Punch small{200, 150};
  small.half_length_mm = small.half_width_mm = 1.0;
  EXPECT_THAT(sentence(make_punch_press(scene, kLayer, small, 1.0, random, "small")),
              HasSubstr("touches too little"));
}

TEST(SteppedPunch, AloneIsNoCalibration) {
  std::mt19937 random(8);
  const MadeScene scene = flat_scene();
  const auto done = calibrate({make_punch_press(scene, kLayer, {200, 150}, 1.0, random, "step")},
                              scene.camera, scene.face, {}, Job{});
  ASSERT_FALSE(done.ok());
  EXPECT_THAT(done.error().sentence(), HasSubstr("pressing a ball at least once as well"));
}

/// Presses of a rod in any direction on the face.
void add_rods(int count, std::mt19937& random, std::vector<Press>* presses) {
  const MadeScene scene = flat_scene();
  const auto shape = std::make_shared<const MeshDistance>(
      MeshDistance::create(test::rod(Rod{}.radius_mm, Rod{}.half_length_mm)).value());
  std::uniform_real_distribution<double> turn(0.0, M_PI), tilt(-0.02, 0.02), depth(0.6, 0.9);
  for (int i = 0; i < count; ++i) {
    Rod rod{200, 150};
    rod.turn = turn(random);
    rod.tilt = tilt(random);
    rod.depth_mm = depth(random);
    presses->push_back(make_rod_press(scene, kLayer, rod, kNoise, random, fmt::format("rod{}", i)));
    presses->back().body = KnownBody{"rod.stl", shape};
  }
}

TEST(KnownBodies, AreReadByTheMappingOnInclinedFacesToo) {
  const MappingCurve curve = curve_of_layer();
  const MeshDistance shape =
      MeshDistance::create(test::rod(Rod{}.radius_mm, Rod{}.half_length_mm)).value();
  for (const double incline : {0.0, 20.0, 35.0}) {
    double sum = 0, most = 0, sd = 0;
    constexpr int kRuns = 6;
    for (unsigned run = 0; run < kRuns; ++run) {
      std::mt19937 random(run);
      const MadeScene scene = finger_scene(80.0, incline);
      std::uniform_real_distribution<double> turn(0.0, M_PI), tilt(-0.03, 0.03);
      Rod rod{480, 300};
      rod.turn = turn(random);
      rod.tilt = tilt(random);
      const Press press = make_rod_press(scene, kLayer, rod, 1.0, random, "rod");
      const auto body = find_body("rod", sample_for_body(press, scene.face), shape, curve,
                                  MappingAlong::kZ, Job{});
      ASSERT_TRUE(body.ok()) << incline << ": " << body.error().sentence();
      const ScaleReading reading =
          read_scale(KnownShape(*body), curve, curve.values().data(), MappingAlong::kZ);
      sum += (reading.scale - 1) / kRuns;
      sd += reading.sd / kRuns;
      most = std::max(most, std::abs(reading.scale - 1) / reading.sd);
    }
    std::printf(
        "[ figures  ] face inclined by %.0f deg: depths on a rod read %+.2f %% too large, at most "
        "%.1f of their sd of %.2f %%\n",
        incline, 100 * sum, most, 100 * sd);
    EXPECT_NEAR(sum, 0.0, 0.01) << incline;
    EXPECT_LT(most, 3.0) << incline;
  }
}

TEST(KnownBodies, SettleTheScale) {
  const auto by_pictures = spread_of("three balls alone", [](std::mt19937& random) {
    return ball_presses(0, 0.01, random, kFewBalls);
  });
  const auto with = spread_of("with two rods", [](std::mt19937& random) {
    auto presses = ball_presses(0, 0.01, random, kFewBalls);
    add_rods(2, random, &presses);
    return presses;
  });
  EXPECT_LT(with.sd, 0.95 * by_pictures.sd);
  EXPECT_LT(with.error, 1.2 * by_pictures.error);
  EXPECT_LT(with.z2, 2.5);
}

// A ball that is smaller than given makes depths too large, and the presses of balls cannot show
// it.
TEST(KnownBodies, CorrectTheScaleOfAWrongRadius) {
  const auto with_wrong_radius = [](std::mt19937& random) {
    auto presses = ball_presses(0, 0.01, random);
    for (Press& press : presses) press.ball_radius_mm *= 1.04;
    return presses;
  };
  const auto by_pictures = spread_of("balls given 4 % too large", with_wrong_radius);
  const auto with = spread_of("the same with three rods", [&](std::mt19937& random) {
    auto presses = with_wrong_radius(random);
    add_rods(3, random, &presses);
    return presses;
  });
  EXPECT_GT(by_pictures.error, 0.03);
  EXPECT_LT(with.error, 0.85 * by_pictures.error);
}

TEST(KnownBodies, ThatContradictTheBallsAreNotUsed) {
  std::mt19937 random(6);
  auto presses = ball_presses(0, 0.01, random);
  add_rods(1, random, &presses);
  for (Press& press : presses)
    if (press.is_ball()) press.ball_radius_mm *= 1.25;  // as a mistyped diameter
  const MadeScene scene = flat_scene();
  const auto done = calibrate(presses, scene.camera, scene.face, {}, Job{});
  ASSERT_TRUE(done.ok()) << done.error().sentence();
  EXPECT_THAT(done->bodies, testing::IsEmpty());
  EXPECT_THAT(done->left_out,
              testing::Contains(testing::Property(
                  &Message::english, testing::AllOf(HasSubstr("rod0: its body was left out"),
                                                    HasSubstr("check the balls' radius")))));
}

TEST(KnownBodies, AloneAreNoCalibration) {
  std::mt19937 random(8);
  std::vector<Press> presses;
  add_rods(2, random, &presses);
  const MadeScene scene = flat_scene();
  const auto done = calibrate(presses, scene.camera, scene.face, {}, Job{});
  ASSERT_FALSE(done.ok());
  EXPECT_THAT(done.error().sentence(), HasSubstr("pressing a ball at least once as well"));
}

TEST(MeasuredCosts, OfADepthHaveTheDerivativesThatDifferencesShow) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  WeightedPress weighted;
  weighted.ball_radius_mm = 4.0;
  weighted.given_depth = {0.7, 0.013};
  for (int round = 0; round < 20; ++round) {
    weighted.plane.normal = Eigen::Vector3d(uniform(random), uniform(random), 2.0).normalized();
    const GivenDepthCost cost(weighted);
    const Eigen::Vector3d at(uniform(random), uniform(random), 23.0);
    const auto value = [&](const Eigen::Vector3d& there) {
      const double* parameters[] = {there.data()};
      double residual = 0;
      EXPECT_TRUE(cost.Evaluate(parameters, &residual, nullptr));
      return residual;
    };
    Eigen::Vector3d gradient;
    double residual = 0;
    const double* parameters[] = {at.data()};
    double* jacobians[] = {gradient.data()};
    ASSERT_TRUE(cost.Evaluate(parameters, &residual, jacobians));
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-5;
      Eigen::Vector3d up = at, down = at;
      up[k] += kStep;
      down[k] -= kStep;
      EXPECT_NEAR(gradient[k], (value(up) - value(down)) / (2 * kStep),
                  1e-6 * gradient.cwiseAbs().maxCoeff());
    }
  }
}

TEST(MeasuredCosts, OfAStepHaveTheValueAndDerivativesOfItsReading) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  const MadeScene scene = flat_scene();
  const Press press = make_punch_press(scene, kLayer, {200, 150}, 1.0, random, "step");
  const KnownShape step = find_step(press, scene.face).value();
  for (int round = 0; round < 20; ++round) {
    MappingCurve curve({MappingKind::kMoebius, 3}, 0.6);
    curve.values() << 1.8 + 0.3 * uniform(random), 0.2 * uniform(random), 0.06;
    const Eigen::Vector3d at = curve.values();
    const ScaleReading reading = read_scale(step, curve, at.data(), MappingAlong::kZ);
    const double root_weight = kRootWeightOfKnown / reading.sd;
    const ScaleCost cost(step, curve, MappingAlong::kZ);
    Eigen::Vector3d gradient;
    double residual = 0;
    const double* parameters[] = {at.data()};
    double* jacobians[] = {gradient.data()};
    ASSERT_TRUE(cost.Evaluate(parameters, &residual, jacobians));
    EXPECT_DOUBLE_EQ(residual, root_weight * (reading.scale - 1));
    for (int k = 0; k < 3; ++k) {
      constexpr double kStep = 1e-5;
      Eigen::Vector3d up = at, down = at;
      up[k] += kStep;
      down[k] -= kStep;
      const double difference = (read_scale(step, curve, up.data(), MappingAlong::kZ).scale -
                                 read_scale(step, curve, down.data(), MappingAlong::kZ).scale) /
                                (2 * kStep);
      // A step's planes turn with the depths, which counts a hundredth of the whole.
      EXPECT_NEAR(gradient[k], root_weight * difference, 0.02 * gradient.cwiseAbs().maxCoeff());
    }
  }
}

}  // namespace
}  // namespace alltact
