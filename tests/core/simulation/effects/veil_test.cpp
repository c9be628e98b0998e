#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Veil, SpreadsAShareOfTheLightEvenly) {
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  double sum = 0;
  for (const float value : plain) sum += value;
  const double mean = sum / static_cast<double>(plain.total());
  Parameters random(6);
  for (int i = 0; i < 4; ++i) {
    const double g = random.between(0.001, 0.2);
    const cv::Mat_<float> veiled =
        rendered(scene_text(kFaceAndLamps + fmt::format("  - {{use: veil, share: {}}}\n", g)));
    for_pixels(plain.size(), 3, [&](int v, int u) {
      EXPECT_NEAR(veiled(v, u), (1 - g) * plain(v, u) + g * mean, 1e-6 * (1 + plain(v, u)));
    });
  }
}

}  // namespace
}  // namespace alltact
