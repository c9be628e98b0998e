#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(BlackLevel, AddsToEveryPixelAfterTheNoise) {
  Parameters random(12);
  const std::string noisy = kFaceAndLamps + "  - {use: shot, gain: 0.1}\n";
  const cv::Mat_<float> plain = rendered(scene_text(noisy));
  for (int i = 0; i < 4; ++i) {
    const double level = random.between(0.5, 30);
    const cv::Mat_<float> got =
        rendered(scene_text(noisy + fmt::format("  - {{use: black-level, level: {}}}\n", level)));
    for_pixels(plain.size(), 3, [&](int v, int u) {
      EXPECT_NEAR(got(v, u), plain(v, u) + level, 1e-6 * (1 + std::abs(got(v, u))));
    });
  }
}

}  // namespace
}  // namespace alltact
