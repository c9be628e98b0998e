#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Absorption, FallsWithTheWayFromEachLampAndToTheCamera) {
  Parameters random(8);
  for (int i = 0; i < 4; ++i) {
    const double per_mm = random.between(0.001, 0.05);
    const Eigen::Vector3d one(random.between(-20, 20), 3, -2), two(4, random.between(-9, 9), 5);
    const cv::Mat_<float> image = rendered(flat_text(fmt::format(
        "  - {{use: leds, lamps: [{{at_mm: [{}, 3, -2], power: 100000}}, {{at_mm: [4, {}, 5], "
        "power: 60000}}]}}\n  - {{use: absorption, per_mm: {}}}\n",
        one.x(), two.y(), per_mm)));
    for_pixels(image.size(), 3, [&](int v, int u) {
      const Eigen::Vector3d p = flat_point(u, v);
      const auto from = [&](const Eigen::Vector3d& lamp, double power) {
        const double way = (lamp - p).norm();
        return power * (p.z() - lamp.z()) / std::pow(way, 3) * std::exp(-per_mm * (way + p.norm()));
      };
      EXPECT_NEAR(image(v, u) / (from(one, 100000) + from(two, 60000)), 1, 2e-6);
    });
  }
}

TEST(Absorption, NeedsLamps) {
  EXPECT_THAT(refusal(flat_text("  - {use: absorption, per_mm: 0.01}\n")), HasSubstr("leds too"));
}

}  // namespace
}  // namespace alltact
