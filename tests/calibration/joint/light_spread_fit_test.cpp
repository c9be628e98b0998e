#include "calibration/joint/light_spread_fit.h"

#include "calibration/joint/calibrate.h"
#include "calibration/joint/spread_model.h"
#include "tests/support/made_press.h"
#include "tests/support/walked_layer.h"

#include <cmath>
#include <optional>
#include <random>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact {
namespace {

using namespace made;

constexpr double kReachMm = 7.0;

struct RoundPress {
  double u, v, radius_mm, depth_mm;
};

/// `at`: in pixels, counted so that column 200 and row 150 are the middle of the image, where a
/// scene is seen straight.
Press press_of(const MadeScene& scene, const ShownRound& shown, const RoundPress& at,
               std::mt19937& random, const std::string& name) {
  const cv::Size size = scene.camera.size();
  const Eigen::Vector2d move(0.5 * size.width - 200.0, 0.5 * size.height - 150.0);
  const Eigen::Vector2d middle = move + Eigen::Vector2d(at.u, at.v);
  const Eigen::Vector3d here_mm = scene.shape.at(middle.x(), middle.y()).value().view_point_mm;
  std::normal_distribution<float> normal;
  cv::Mat x(size, CV_32FC1), grain(size, CV_32FC1);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const auto local = scene.shape.at(u, v);
      x.at<float>(v, u) =
          local ? static_cast<float>(shown.at((local->view_point_mm - here_mm).norm())) : 0.0F;
      grain.at<float>(v, u) = normal(random);
    }
  return {name, noisy_difference(x, grain, 1.0), scene.shape, at.radius_mm};
}

const std::vector<RoundPress> kPresses{
    {150, 120, 4.0, 0.4}, {250, 180, 2.0, 0.6}, {180, 190, 4.0, 0.75}, {260, 110, 4.0, 0.9},
    {200, 150, 2.0, 0.5}, {160, 160, 2.0, 0.7}, {170, 170, 6.0, 0.5},  {230, 140, 3.0, 0.8},
    {210, 165, 6.0, 0.8}, {190, 140, 1.5, 0.4}, {220, 150, 2.0, 0.85}, {205, 155, 6.0, 0.95}};

std::vector<Press> ball_presses(const MadeScene& scene, const WalkedLayer& layer,
                                const Contact& contact, std::mt19937& random) {
  std::vector<Press> presses;
  for (const RoundPress& at : kPresses) {
    const Relief relief(contact, at.radius_mm, at.depth_mm);
    const ShownRound shown(
        layer, [&](double r) { return relief(r); }, kReachMm);
    presses.push_back(press_of(scene, shown, at, random, fmt::format("p{}", presses.size())));
  }
  return presses;
}

/// Depth that a calibration reads in the middle of a flat punch, and 1 mm beside its rim.
struct PunchReading {
  double middle_mm, beside_mm;
};
PunchReading read_punch(const Press& punch, const MappingParameters& parameters) {
  const Mapping mapping = Mapping::create(parameters).value();
  const DepthMap map = depth_map(punch.difference, mapping, punch.shape);
  const auto mean = [&](const cv::Rect& box) { return cv::mean(map.depth_mm(box))[0]; };
  return {mean({190, 140, 20, 20}), mean({255, 140, 10, 20})};
}

TEST(LightSpreadFit, BallsOnAWalkedLayerMakeAPunchReadRight) {
  // With 0.9 and less, or fewer presses, the fit is as near, but unusual skin explains as much:
  // without oblique sight only the form of the profiles differs.
  for (const double optical : {1.6}) {
    std::mt19937 random(17);
    const WalkedLayer layer(1.5, optical, 0.6, 12000, 5);
    const MadeScene scene = flat_scene();
    const std::vector<Press> presses = ball_presses(scene, layer, {Skin::kSmooth, 0.1, 0}, random);
    // A punch of 2 mm radius, 0.5 mm deep, with walls of a tenth of a millimetre.
    const auto flat = [](double r) { return 0.5 / (1.0 + std::exp((r - 2.0) / 0.03)); };
    const Press punch =
        press_of(scene, ShownRound(layer, flat, kReachMm), {200, 150, 4.0, 0.5}, random, "punch");

    const auto spread = calibrate(presses, scene.camera, scene.face, {}, Job{});
    ASSERT_TRUE(spread.ok()) << spread.error().sentence();
    EXPECT_FALSE(spread->mapping.spread.is_local());
    for (std::size_t i = 0; i < kPresses.size(); ++i)
      EXPECT_NEAR(spread->balls[i].indentation_mm, kPresses[i].depth_mm, 0.1 * kPresses[i].depth_mm)
          << optical << " press " << i;
    CalibrationSettings as_local;
    as_local.light_spread = LightSpreadChoice::kLocal;
    const auto local = calibrate(presses, scene.camera, scene.face, as_local, Job{});
    ASSERT_TRUE(local.ok());
    const PunchReading with = read_punch(punch, spread->mapping),
                       without = read_punch(punch, local->mapping);
    EXPECT_NEAR(with.middle_mm, 0.5, 0.04) << optical;
    EXPECT_NEAR(with.beside_mm, 0.0, 0.02) << optical;
    EXPECT_GT(std::abs(without.middle_mm - 0.5), 1.5 * std::abs(with.middle_mm - 0.5)) << optical;
    EXPECT_GT(without.beside_mm, 2.0 * std::abs(with.beside_mm)) << optical;
  }
}

/// Of balls that are found by their brightness.
std::optional<LightSpreadFit> fit_to(const std::vector<Press>& presses, const MadeScene& scene) {
  std::vector<BallStart> balls;
  for (const Press& press : presses)
    balls.push_back({&press, find_ball(press, scene.face).value().centre_mm});
  return fit_light_spread(balls, scene.face, {}, Job{});
}

// A lamp that moves relative to the face changes all that is seen around one ball.
TEST(LightSpreadFit, APressUnderOtherLightMovesNoBall) {
  std::mt19937 random(19);
  const MadeScene scene = finger_scene(30.0, 0.0);
  const WalkedLayer layer(1.5, 2.2, 0.6, 12000, 5);
  std::vector<Press> presses = ball_presses(scene, layer, {Skin::kSmooth, 0.1, 0}, random);
  const auto before = fit_to(presses, scene);
  constexpr double kBrighter = 0.03;
  cv::Mat x = presses[3].difference.x;
  x -= kBrighter * (1.0 - x);
  const auto after = fit_to(presses, scene);
  ASSERT_TRUE(before && after);
  ASSERT_TRUE(before->is_seen && after->is_seen);
  for (std::size_t i = 0; i < presses.size(); ++i)
    EXPECT_LT((after->centres_mm[i] - before->centres_mm[i]).norm(), 0.02) << "press " << i;
}

TEST(LightSpreadFit, LocalLightIsNotTakenForSpreadWhateverTheSkinDoes) {
  std::mt19937 random(23);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (const Contact& contact : {Contact{Skin::kSharp, 0, 0}, Contact{Skin::kSmooth, 0.1, 0.03},
                                 Contact{Skin::kSmooth, 0.25, 0}, Contact{Skin::kTail, 0.75, 0},
                                 Contact{Skin::kTail, 0.6, 0.02}, Contact{Skin::kHertz, 0, 0.03},
                                 Contact{Skin::kHertz, 0, 0}}) {
    const Layer layer{0.3 + 1.2 * uniform(random), 0.05 * uniform(random)};
    std::vector<Press> presses;
    const MadeScene scene = flat_scene();
    for (const RoundPress& at : kPresses)
      presses.push_back(make_press(scene, layer, contact, {{at.u, at.v, at.radius_mm, at.depth_mm}},
                                   1.0, random, fmt::format("p{}", presses.size()))
                            .press);
    const auto fit = fit_to(presses, scene);
    ASSERT_TRUE(fit.has_value());
    EXPECT_FALSE(fit->is_seen) << "skin " << static_cast<int>(contact.skin) << ' ' << contact.size
                               << ' ' << contact.bulge_mm << ": " << fit->log_evidence;
  }
}

// Solved like the table in light_spread_test.cpp, sight along the normal: rho and b where lamps are
// near the camera and 1 % is absorbed, b where light is along the normal and nothing is absorbed,
// and b for light at 44 degrees with 2 %.
struct SolvedCurve {
  double optical_thickness, rho, b, least_b, most_b;
};
constexpr SolvedCurve kSolvedCurves[] = {{0.6, 0.973, 0.112, 0.064, 0.190},
                                         {1.2, 0.962, 0.366, 0.256, 0.543},
                                         {2.0, 0.948, 0.797, 0.566, 1.160},
                                         {3.0, 0.931, 1.486, 1.016, 2.208}};

TEST(LightSpreadFit, PriorsOfTheCurveHoldWhatTheEquationOfTransferGives) {
  for (const SolvedCurve& solved : kSolvedCurves) {
    const CurvePrior rho = rho_prior(solved.optical_thickness),
                     b = b_prior(solved.optical_thickness);
    EXPECT_LT(std::abs(std::log(solved.rho) - rho.mean), rho.sd) << solved.optical_thickness;
    EXPECT_NEAR(std::exp(b.mean) / solved.b, 1.0, 0.15) << solved.optical_thickness;
    for (const double other : {solved.least_b, solved.most_b})
      EXPECT_LT(std::abs(std::log(other) - b.mean), 1.5 * b.sd) << solved.optical_thickness;
  }
}

TEST(LightSpreadFit, PriorsOfTheCurveHaveTheDerivativesOfDifferences) {
  constexpr double kStep = 1e-4;
  for (const double optical_thickness : {0.2, 0.7, 1.5, 3.0})
    for (const auto& prior : {rho_prior, b_prior}) {
      const CurvePrior here = prior(optical_thickness),
                       up = prior(optical_thickness * std::exp(kStep)),
                       down = prior(optical_thickness * std::exp(-kStep));
      EXPECT_NEAR(here.mean_by_log, 0.5 * (up.mean - down.mean) / kStep, 1e-4);
      EXPECT_NEAR(here.sd_by_log, 0.5 * (up.sd - down.sd) / kStep, 1e-4);
    }
}

}  // namespace
}  // namespace alltact
