#include "tests/core/simulation/effects/effect_scene.h"
#include "tests/support/walked_layer.h"

namespace alltact {
namespace {

using made::WalkedLayer;

constexpr double kPixelMm = 0.05, kThicknessMm = 1.5, kCosLight = 0.6;

/// A flat sensor of 20 x 15 mm, seen along its normal.
cv::Mat_<float> sensor(const std::string& effects) {
  return rendered(flat_text(
      effects, "model: orthographic, size: [400, 300], mm_per_px: 0.05, cx: 200, cy: 150"));
}

std::string scatter(double per_mm) {
  return fmt::format("  - {{use: scatter, scatter_per_mm: {}, light_deg: {}}}\n", per_mm,
                     std::acos(kCosLight) * 180 / M_PI);
}

TEST(Scatter, ShowsABallAsAWalkedLayerDoes) {
  constexpr double kRadiusMm = 4, kDepthMm = 0.5;
  const std::string ball = fmt::format(
      "  - {{use: ball, s_mm: 0, y_mm: 0, radius_mm: {}, depth_mm: {}}}\n", kRadiusMm, kDepthMm);
  const auto depth_mm = [&](double r) {
    return r < kRadiusMm
               ? std::max(0.0, kDepthMm - kRadiusMm + std::sqrt(kRadiusMm * kRadiusMm - r * r))
               : 0.0;
  };
  for (const double per_mm : {0.4, 0.8, 1.6}) {
    const cv::Mat_<float> untouched = sensor(scatter(per_mm));
    const cv::Mat_<float> pressed = sensor(scatter(per_mm) + ball);
    const WalkedLayer layer(kThicknessMm, per_mm * kThicknessMm, kCosLight, 100000, 11);
    for (const double r : {0.0, 0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0}) {
      const double truth =
          layer.difference([&](double dx, double dy) { return depth_mm(std::hypot(r + dx, dy)); });
      for (const auto& [along, across] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}}) {
        const int u = 200 + along * static_cast<int>(std::lround(r / kPixelMm)),
                  v = 150 + across * static_cast<int>(std::lround(r / kPixelMm));
        const double x = 1 - double{pressed(v, u)} / double{untouched(v, u)};
        EXPECT_NEAR(x, truth, per_mm < 1 ? 0.006 : 0.011)
            << per_mm << ' ' << r << ' ' << along << ' ' << across;
      }
    }
  }
}

TEST(Scatter, ChangesNothingFarFromAPress) {
  const std::string ball = "  - {use: ball, s_mm: -5, y_mm: 0, radius_mm: 2, depth_mm: 0.5}\n";
  const cv::Mat_<float> untouched = sensor(scatter(0.6)), pressed = sensor(scatter(0.6) + ball);
  EXPECT_NEAR(pressed(150, 100) / untouched(150, 100), 0.8, 0.1);
  EXPECT_NEAR(pressed(150, 380) / untouched(150, 380), 1, 1e-4);
  EXPECT_NEAR(untouched(150, 380) / untouched(40, 20), 1, 1e-4) << "even, seen straight";
}

/// Light that an infinitely thick layer of albedo 0.9 reflects straight up, by Chandrasekhar's H of
/// isotropic scattering: R = 0.9 H(1) H(cos) / (4 (1 + cos)), H from its integral equation.
double of_half_space(double cos_light) {
  constexpr int kNodes = 400;
  std::vector<double> h(kNodes, 1.0);
  const auto node = [](int i) { return (i + 0.5) / kNodes; };
  const auto at = [&](double mu) {
    double sum = 0;
    for (int i = 0; i < kNodes; ++i)
      sum += h[static_cast<std::size_t>(i)] * mu / (mu + node(i)) / kNodes;
    return 1 / (1 - 0.5 * 0.9 * sum);
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<double> next;
    for (int i = 0; i < kNodes; ++i) next.push_back(at(node(i)));
    h = next;
  }
  return 0.9 * at(1) * at(cos_light) / (4 * (1 + cos_light));
}

TEST(Scatter, ReflectsAThickLayerByChandrasekhar) {
  // 6 mean free paths thick.
  const cv::Mat_<float> got = sensor(
      fmt::format("  - {{use: scatter, scatter_per_mm: 3.6, absorb_per_mm: 0.4, light_deg: {}}}\n",
                  std::acos(kCosLight) * 180 / M_PI));
  EXPECT_NEAR(got(150, 200), of_half_space(kCosLight), 0.03 * of_half_space(kCosLight));
}

TEST(Scatter, DarkensAFingerTowardsItsSides) {
  const cv::Mat_<float> got = rendered(scene_text("  - {use: scatter, scatter_per_mm: 0.6}\n"));
  constexpr int kColumn = 120;
  int first = 0;  // row of the face
  while (got(first, kColumn) == 0) ++first;
  const double middle = got(90, kColumn);
  EXPECT_LT(got(first + 2, kColumn), 0.9 * middle);
  EXPECT_GT(got(first + 2, kColumn), 0.4 * middle) << "what turns once comes from the sides, too";
  for (int row = first + 3; row < 60; ++row)
    EXPECT_GT(got(row, kColumn), 0.999 * double{got(row - 1, kColumn)}) << row;
}

TEST(Scatter, IsRefusedBesideALocalLayer) {
  const auto scene = Scene::parse(flat_text(kFaceAndLamps + scatter(0.6)), "scene.yaml");
  ASSERT_TRUE(scene);
  const auto plan = Plan::compile(*scene, 7);
  ASSERT_FALSE(plan);
  EXPECT_THAT(plan.error().sentence(), testing::HasSubstr("its light is local or scatters"));
}

}  // namespace
}  // namespace alltact
