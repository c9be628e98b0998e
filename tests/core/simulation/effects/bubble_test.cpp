#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Bubble, ThinsTheLayerByItsChord) {
  Parameters random(27);
  for (const char* absorb : {"", ", absorb_per_mm: 0.000001"})
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d at(random.between(-15, 15), random.between(-8, 8));
      const double radius = random.between(0.3, 0.75);
      const std::string layer =
          fmt::format("  - {{use: layer, scatter_per_mm: 0.6, along: normal{}}}\n", absorb);
      const Plan plan = plan_of(
          flat_text(layer + fmt::format("  - {{use: bubble, s_mm: {}, y_mm: {}, radius_mm: {}}}\n",
                                        at.x(), at.y(), radius)));
      const cv::Mat_<float> got = plan.render(0);
      int inside = 0;
      for_pixels(got.size(), 1, [&](int v, int u) {
        const double h2 = radius * radius - (flat_point(u, v).head<2>() - at).squaredNorm();
        if (std::abs(h2) < 1e-3) return;  // where the chord falls like a root
        const double t = 1.5 - (h2 > 0 ? 2 * std::sqrt(h2) : 0.0);
        ASSERT_NEAR(got(v, u), 0.6 * t / (1 + 0.6 * t), 2e-4);
        inside += h2 > 0;
      });
      EXPECT_GT(inside, 8);
      EXPECT_EQ(plan.truth(0).depth_mm.at<float>(90, 160), 0.0F);
      EXPECT_EQ(plan.truth(0).untouched_z_mm.at<float>(90, 160), 31.5F);
    }
}

// On a slanted face the chord along z is longer by as much as the layer is.
TEST(Bubble, LiesInASlantedLayer) {
  for (const std::string along : {"z", "normal"}) {
    const std::string layer = "  - {use: layer, scatter_per_mm: 0.6, along: " + along + "}\n";
    const cv::Mat_<float> got =
        rendered(scene_text(layer + "  - {use: bubble, s_mm: 40, y_mm: 1, radius_mm: 0.7}\n"));
    const double theta = 34 * M_PI / 180, x = -25 + 40 * std::cos(theta);
    const double z = 28 + 40 * std::sin(theta);
    const int u = static_cast<int>(std::lround(158.5 + 170 * x / z));
    const int v = static_cast<int>(std::lround(90.25 + 172 / z));
    const double dx = (u - 158.5) / 170;
    const double z_hit =
        (28 * std::cos(theta) + 25 * std::sin(theta)) / (std::cos(theta) - dx * std::sin(theta));
    const double s = (dx * z_hit + 25) / std::cos(theta), y = (v - 90.25) / 172 * z_hit;
    const double chord = 2 * std::sqrt(0.49 - std::pow(s - 40, 2) - std::pow(y - 1, 2));
    const double t = (1.5 - chord) / (along == "z" ? std::cos(theta) : 1.0);
    EXPECT_NEAR(got(v, u), 0.6 * t / (1 + 0.6 * t), 1e-4) << along;
  }
}

TEST(Bubble, HasItsPlace) {
  const std::string layer = "  - {use: layer, scatter_per_mm: 0.6, along: normal}\n";
  EXPECT_THAT(refusal(flat_text("  - {use: bubble, s_mm: 0, y_mm: 0, radius_mm: 0.5}\n")),
              HasSubstr("layer too"));
  EXPECT_THAT(refusal(flat_text(layer + "  - {use: bubble, s_mm: 0, y_mm: 0, radius_mm: 0.8}\n")),
              HasSubstr("radius_mm up to 0.75"));
}

}  // namespace
}  // namespace alltact
