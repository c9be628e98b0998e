#include "calibration/joint/calibrate.h"

#include "calibration/joint/joint_fit.h"
#include "tests/support/made_press.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

/// Largest difference between the mapping and the truth over the calibrated domain.
double mapping_error(const MappingParameters& parameters, const Layer& layer) {
  const Mapping mapping = Mapping::create(parameters).value();
  double worst = 0;
  for (int i = 0; i <= 200; ++i) {
    const double x = mapping.x_max() * i / 200.0;
    worst = std::max(worst, std::abs(mapping.depth_mm(x) - layer.depth_at(x)));
  }
  return worst;
}

std::vector<Press> flat_presses(const Layer& layer, const Contact& contact, int count,
                                std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::vector<Press> presses;
  for (int i = 0; i < count; ++i) {
    const Ball ball{110 + 180 * uniform(random), 90 + 120 * uniform(random), 4.0,
                    count == 1 ? 1.0 : 0.4 + 0.8 * (i + uniform(random)) / count};
    presses.push_back(
        make_press(flat_scene(), layer, contact, {ball}, 1.0, random, fmt::format("p{}", i)).press);
  }
  return presses;
}

Calibration calibration_of(const std::vector<Press>& presses,
                           const CalibrationSettings& settings = {}) {
  const MadeScene scene = flat_scene();
  auto result = calibrate(presses, scene.camera, scene.face, settings, Job{});
  EXPECT_TRUE(result.ok()) << result.error().sentence();
  return result.value();
}

TEST(Calibrate, SixPressesGiveTheMappingWhateverTheSkinDoesAtTheRim) {
  std::mt19937 random(21);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const Contact& contact : {Contact{Skin::kSharp, 0, 0}, Contact{Skin::kSmooth, 0.1, 0.03},
                                 Contact{Skin::kSmooth, 0.2, 0}, Contact{Skin::kTail, 0.85, 0},
                                 Contact{Skin::kHertz, 0, 0.03}}) {
    const Layer layer{0.3 + 1.2 * uniform(random), 0.05 * uniform(random)};
    const Calibration calibration = calibration_of(flat_presses(layer, contact, 6, random));
    EXPECT_LT(mapping_error(calibration.mapping, layer), 0.02)
        << "skin " << static_cast<int>(contact.skin) << " size " << contact.size;
    EXPECT_EQ(calibration.balls.size(), 6U);
    EXPECT_GT(calibration.held_out_mm, 0.0);
  }
}

TEST(Calibrate, ThreePressesWithoutRollOffGiveTheMappingToAHundredth) {
  std::mt19937 random(22);
  const Layer layer{0.6, 0.02};
  const Calibration calibration = calibration_of(flat_presses(layer, {}, 3, random));
  EXPECT_LT(mapping_error(calibration.mapping, layer), 0.01);
}

// On a layer so thick to the light that 0.2 mm darken it by 2 %, shallow presses are worth having
// as well: left out, the mapping's beginning would rest on the others' rims.
TEST(Calibrate, FaintPressesOnAStronglyScatteringLayerCount) {
  std::mt19937 random(27);
  const Layer layer{6.0, 0.02};
  const double depths_mm[] = {0.2, 0.3, 0.45, 0.7, 0.9, 1.1};
  ASSERT_LT(layer.difference_at(depths_mm[0]), 0.025);
  std::vector<Press> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  for (int i = 0; i < 6; ++i) {
    const Made made =
        make_press(flat_scene(), layer, {}, {{120.0 + 30 * i, 100.0 + 20 * i, 4.0, depths_mm[i]}},
                   1.0, random, fmt::format("p{}", i));
    presses.push_back(made.press);
    centres_mm.push_back(made.centre_mm);
  }
  const Calibration calibration = calibration_of(presses);
  EXPECT_LT(mapping_error(calibration.mapping, layer), 0.02);
  ASSERT_EQ(calibration.balls.size(), 6U)
      << (calibration.left_out.empty() ? "" : calibration.left_out.front().english());
  for (const BallFit& ball : calibration.balls) {
    const auto i = static_cast<std::size_t>(std::stoi(ball.press.substr(1)));
    EXPECT_NEAR(ball.centre_mm.z(), centres_mm[i].z(), 0.02) << ball.press;
  }
}

TEST(Calibrate, TellsHowTheSolutionSettlesAndThatChangesNothing) {
  std::mt19937 random(22);
  const std::vector<Press> presses = flat_presses({0.6, 0.02}, {}, 3, random);
  std::vector<Round> rounds;
  const auto listen = [&](const Round& round) { rounds.push_back(round); };
  const MadeScene scene = flat_scene();
  const auto heard = calibrate(presses, scene.camera, scene.face, {}, Job{}, listen);
  ASSERT_TRUE(heard.ok()) << heard.error().sentence();
  ASSERT_GE(rounds.size(), 3U);
  EXPECT_EQ(rounds.front().number, 1);
  EXPECT_LT(rounds.back().change_mm, JointOptions{}.settled_mm);
  EXPECT_GT(rounds.front().change_mm, 1e3 * rounds.back().change_mm);
  EXPECT_NEAR(rounds.back().residual_mm, rounds[rounds.size() - 2].residual_mm, 1e-6);
  // Rounds read smaller blocks, which hold more noise than those of presses left out.
  EXPECT_GT(rounds.back().residual_mm, heard->residual_mm);
  EXPECT_LT(rounds.back().residual_mm, 2 * heard->residual_mm);
  EXPECT_EQ(heard->mapping.chebyshev, calibration_of(presses).mapping.chebyshev);
}

TEST(Calibrate, BallsOfSeveralSizesGiveOneMapping) {
  std::mt19937 random(29);
  const Layer layer{0.7, 0.02};
  const MadeScene scene = flat_scene();
  const double radii_mm[] = {2.0, 5.0, 3.0, 4.0};
  std::vector<Press> presses;
  std::vector<Eigen::Vector3d> centres_mm;
  for (int i = 0; i < 4; ++i) {
    Made made = make_press(scene, layer, {Skin::kHertz, 0, 0.02},
                           {{130.0 + 40 * i, 110.0 + 25 * i, radii_mm[i], 0.5 + 0.15 * i}}, 1.0,
                           random, fmt::format("p{}", i));
    presses.push_back(std::move(made.press));
    centres_mm.push_back(made.centre_mm);
  }
  const Calibration calibration = calibration_of(presses);
  ASSERT_EQ(calibration.balls.size(), 4U);
  EXPECT_LT(mapping_error(calibration.mapping, layer), 0.02);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(calibration.balls[i].radius_mm, radii_mm[i]);
    EXPECT_LT((calibration.balls[i].centre_mm - centres_mm[i]).norm(), 0.03) << radii_mm[i];
  }
  // Taken for one size they do not fit.
  for (Press& press : presses) press.ball_radius_mm = 4.0;
  EXPECT_GT(calibration_of(presses).residual_mm, 1.5 * calibration.residual_mm);
}

TEST(Calibrate, OnePressSaysWhatItCannotKnow) {
  std::mt19937 random(23);
  const Layer layer{0.6, 0.02};
  const Calibration calibration =
      calibration_of(flat_presses(layer, {Skin::kHertz, 0, 0.02}, 1, random));
  EXPECT_LT(mapping_error(calibration.mapping, layer), 0.05);
  EXPECT_EQ(calibration.held_out_mm, 0.0);
  EXPECT_TRUE(std::any_of(calibration.remarks.begin(), calibration.remarks.end(),
                          [](const Message& r) { return r.english().find("one press") == 0; }));
}

TEST(Calibrate, InclinedFacesTellWhichThicknessCounts) {
  std::mt19937 random(24);
  for (const MappingAlong along :
       {MappingAlong::kZ, MappingAlong::kNormal, MappingAlong::kProjected}) {
    const Layer layer{0.8, 0.02, 1.5, along};
    std::vector<Press> presses;
    std::optional<MadeScene> last;
    const double inclines[] = {-24.0, 0.0, 12.0, 28.0};
    for (int i = 0; i < 4; ++i) {
      last = finger_scene(40.0, inclines[i]);
      presses.push_back(make_press(*last, layer, {},
                                   {{420.0 + 30 * i, 230.0 + 25 * i, 4.0, 0.5 + 0.2 * i}}, 1.0,
                                   random, fmt::format("p{}", i))
                            .press);
    }
    const auto result = calibrate(presses, last->camera, last->face, {}, Job{});
    ASSERT_TRUE(result.ok()) << result.error().sentence();
    EXPECT_EQ(result->mapping.along, along);
    EXPECT_LT(mapping_error(result->mapping, layer), 0.03);
  }
}

TEST(Calibrate, UnevenLightIsSeenAndAnsweredAndEvenLightIsLeftAlone) {
  std::mt19937 random(26);
  for (const Eigen::Vector2d& uneven :
       {Eigen::Vector2d(0.0, 0.0), Eigen::Vector2d(0.15, 0.0), Eigen::Vector2d(-0.08, 0.12)}) {
    Layer layer{0.7, 0.02};
    layer.uneven = uneven;
    const MadeScene scene = flat_scene();
    std::vector<Press> presses;
    const double places[][2] = {{90, 80},   {310, 90},  {200, 150}, {90, 220},
                                {310, 215}, {150, 110}, {260, 190}};
    for (int i = 0; i < 7; ++i)
      presses.push_back(make_press(scene, layer, {},
                                   {{places[i][0], places[i][1], 4.0, 0.4 + 0.1 * i}}, 1.0, random,
                                   fmt::format("p{}", i))
                            .press);
    const Calibration calibration = calibration_of(presses);
    const FaceVariation& found = calibration.mapping.variation;
    EXPECT_EQ(found.is_none(), uneven.isZero(0.0));
    const auto mapping = Mapping::create(calibration.mapping);
    ASSERT_TRUE(mapping.ok());
    double worst = 0;
    for (const Press& press : presses)
      for (const auto& [u, v] :
           {std::pair(100.0, 90.0), {300.0, 100.0}, {110.0, 210.0}, {290.0, 200.0}}) {
        const double factor =
            1.0 + uneven.dot(Eigen::Vector2d(2.0 * u / 400 - 1.0, 2.0 * v / 300 - 1.0));
        const double x = 0.6 * mapping->x_max();
        const double told = mapping->depth_mm(x) * found.at(press.shape.position_mm(u, v));
        worst = std::max(worst, std::abs(told - layer.depth_at(x) * factor));
      }
    EXPECT_LT(worst, 0.02) << uneven.transpose();
    EXPECT_EQ(std::any_of(calibration.remarks.begin(), calibration.remarks.end(),
                          [](const Message& r) {
                            return r.english().find("varies over the face") != std::string::npos;
                          }),
              !uneven.isZero(0.0));
  }
}

TEST(Calibrate, BallsDeeperThanTheLayerAreNoCalibration) {
  std::mt19937 random(7);
  const MadeScene scene = flat_scene();
  std::vector<Press> presses;
  for (int i = 0; i < 4; ++i)
    presses.push_back(make_press(scene, {0.6, 0.02}, {Skin::kHertz},
                                 {Ball{140.0 + 30.0 * i, 120.0 + 16.0 * i, 4.0, 0.7 + 0.08 * i}},
                                 1.0, random, fmt::format("p{}", i))
                          .press);
  Face thin = scene.face;
  thin.layer_mm = 0.5;
  CalibrationSettings settings;
  settings.light_spread = LightSpreadChoice::kLocal;
  const auto done = calibrate(presses, scene.camera, thin, settings, Job{});
  ASSERT_FALSE(done.ok());
  EXPECT_NE(done.error().sentence().find("deep in a layer of 0.50 mm"), std::string::npos)
      << done.error().sentence();
}

TEST(Calibrate, OrderOfPressesDoesNotMatter) {
  std::mt19937 random(25);
  std::vector<Press> presses = flat_presses({0.7, 0.01}, {Skin::kSmooth, 0.1, 0}, 4, random);
  const Calibration first = calibration_of(presses);
  std::reverse(presses.begin(), presses.end());
  std::swap(presses[0], presses[2]);
  const Calibration second = calibration_of(presses);
  EXPECT_EQ(first.mapping.a_mm, second.mapping.a_mm);
  EXPECT_EQ(first.mapping.b, second.mapping.b);
  EXPECT_EQ(first.mapping.chebyshev, second.mapping.chebyshev);
  for (const BallFit& ball : second.balls) {
    const auto same = std::find_if(first.balls.begin(), first.balls.end(),
                                   [&](const BallFit& b) { return b.press == ball.press; });
    ASSERT_NE(same, first.balls.end());
    EXPECT_EQ(same->centre_mm, ball.centre_mm);
  }
  for (std::size_t i = 0; i < presses.size(); ++i)
    EXPECT_EQ(second.balls[i].press, presses[i].name);
}

TEST(Calibrate, TheSamePictureTwiceCountsOnce) {
  std::mt19937 random(26);
  std::vector<Press> presses = flat_presses({0.7, 0.01}, {}, 3, random);
  const Calibration once = calibration_of(presses);
  presses.push_back(presses[1]);
  presses.back().name = "copy";
  const Calibration twice = calibration_of(presses);
  EXPECT_EQ(once.mapping.a_mm, twice.mapping.a_mm);
  EXPECT_EQ(once.mapping.b, twice.mapping.b);
  ASSERT_EQ(twice.left_out.size(), 1U);
  EXPECT_NE(twice.left_out[0].english().find("same image as p1"), std::string::npos);
}

TEST(Calibrate, UnusablePressesAreNamedAndTheRestIsUsed) {
  std::mt19937 random(27);
  const MadeScene scene = flat_scene();
  std::vector<Press> presses = flat_presses({}, {}, 3, random);
  Press empty = make_press(scene, {}, {}, {}, 1.0, random, "empty").press;
  presses.insert(presses.begin() + 1, empty);
  const Calibration calibration = calibration_of(presses);
  EXPECT_EQ(calibration.balls.size(), 3U);
  ASSERT_EQ(calibration.left_out.size(), 1U);
  EXPECT_EQ(calibration.left_out[0].english().rfind("empty: ", 0), 0U);

  const auto refused = calibrate({empty}, scene.camera, scene.face, {}, Job{});
  ASSERT_FALSE(refused.ok());
  EXPECT_NE(refused.error().what.english().find("empty"), std::string::npos);
  EXPECT_FALSE(calibrate({}, scene.camera, scene.face, {}, Job{}).ok());
  presses[1].ball_radius_mm = -4.0;
  EXPECT_FALSE(calibrate(presses, scene.camera, scene.face, {}, Job{}).ok());
}

TEST(Calibrate, AskedForFamiliesAreUsed) {
  std::mt19937 random(28);
  const Layer layer{0.6, 0.0};
  const std::vector<Press> presses = flat_presses(layer, {}, 3, random);
  CalibrationSettings settings;
  settings.family = FamilyChoice::kPolynomial;
  settings.degree = 3;
  const Calibration cubic = calibration_of(presses, settings);
  EXPECT_EQ(cubic.mapping.kind, MappingKind::kPolynomial);
  EXPECT_EQ(cubic.mapping.chebyshev.size(), 3U);
  EXPECT_LT(mapping_error(cubic.mapping, layer), 0.03);
  settings.method = CalibrationMethod::kPaper;
  const Calibration paper = calibration_of(presses, settings);
  EXPECT_EQ(paper.mapping.kind, MappingKind::kPolynomial);
  EXPECT_LT(mapping_error(paper.mapping, layer), 0.2);
}

TEST(Calibrate, StoppedBeforeTheFirstSolutionSaysSo) {
  std::mt19937 random(29);
  const MadeScene scene = flat_scene();
  const std::vector<Press> presses = flat_presses({}, {}, 1, random);
  Job job;
  job.request_stop();
  const auto result = calibrate(presses, scene.camera, scene.face, {}, job);
  ASSERT_FALSE(result.ok());
  EXPECT_NE(result.error().what.english().find("stopped"), std::string::npos);
}

TEST(Calibrate, SettingsSpeakForThemselves) {
  CalibrationSettings settings;
  for (const auto& setting : calibration_settings()) {
    EXPECT_FALSE(setting.sentence.empty());
    EXPECT_TRUE(setting.set(settings, setting.default_value()).ok());
    EXPECT_FALSE(setting.set(settings, "nonsense").ok());
  }
}

TEST(JointFit, DerivativesAgreeWithDifferences) {
  std::mt19937 random(30);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int i = 0; i < 100; ++i) {
    Sample sample;
    sample.normal = Eigen::Vector3d(0.4 * uniform(random), 0.0, 1.0).normalized();
    sample.untouched_n = {uniform(random), uniform(random), 40.0};
    sample.untouched_z = sample.untouched_n + Eigen::Vector3d(0.0, 0.0, 0.1);
    sample.cos_incline = sample.normal.z();
    const Eigen::Vector3d centre(uniform(random), uniform(random), 43.0);
    for (const MappingAlong along :
         {MappingAlong::kZ, MappingAlong::kNormal, MappingAlong::kProjected}) {
      Eigen::Vector3d by_centre;
      EXPECT_TRUE(std::isfinite(ball_depth_mm(sample, along, centre, 4.0, &by_centre)));
      for (int k = 0; k < 3; ++k) {
        constexpr double kStep = 1e-5;
        const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(k);
        const double slope = (ball_depth_mm(sample, along, centre + step, 4.0) -
                              ball_depth_mm(sample, along, centre - step, 4.0)) /
                             (2.0 * kStep);
        EXPECT_NEAR(by_centre[k], slope, 1e-7);
      }
    }
    for (const CurveFamily family :
         {CurveFamily{MappingKind::kMoebius, 2}, CurveFamily{MappingKind::kPolynomial, 5},
          CurveFamily{MappingKind::kMoebius, 3}, CurveFamily{MappingKind::kMoebius, 2, true},
          CurveFamily{MappingKind::kPolynomial, 3, true}}) {
      MappingCurve curve(family, 0.6);
      const Eigen::Vector2d place(uniform(random), uniform(random));
      for (double& value : curve.values()) value = 1.0 + 0.5 * uniform(random);
      const double x = 0.1 + 0.4 * std::abs(uniform(random));
      std::vector<double> gradient(static_cast<std::size_t>(family.numbers()));
      EXPECT_TRUE(std::isfinite(curve.at().depth_mm(x, place, gradient.data())));
      constexpr double kStep = 1e-6;
      EXPECT_NEAR(curve.slope_mm(x),
                  (curve.depth_mm(x + kStep) - curve.depth_mm(x - kStep)) / (2.0 * kStep), 1e-7);
      for (int k = 0; k < family.numbers(); ++k) {
        MappingCurve up = curve, down = curve;
        up.values()[k] += kStep;
        down.values()[k] -= kStep;
        EXPECT_NEAR(gradient[static_cast<std::size_t>(k)],
                    (up.at().depth_mm(x, place) - down.at().depth_mm(x, place)) / (2.0 * kStep),
                    1e-7);
      }
    }
  }
}

}  // namespace
}  // namespace alltact
