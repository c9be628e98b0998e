#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Leak, AddsTheSameToEveryPixel) {
  Parameters random(5);
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  for (int i = 0; i < 4; ++i) {
    const double grey = random.between(0.1, 20), lux = random.between(300, 2500),
                 per_lux = random.between(1e-4, 1e-2);
    const cv::Mat_<float> a =
        rendered(scene_text(kFaceAndLamps + fmt::format("  - {{use: leak, grey: {}}}\n", grey)));
    const cv::Mat_<float> b = rendered(
        scene_text(kFaceAndLamps +
                   fmt::format("  - {{use: leak, lux: {}, grey_per_lux: {}}}\n", lux, per_lux)));
    for_pixels(plain.size(), 3, [&](int v, int u) {
      EXPECT_NEAR(a(v, u), plain(v, u) + grey, 1e-6 * (1 + a(v, u)));
      EXPECT_NEAR(b(v, u), plain(v, u) + lux * per_lux, 1e-6 * (1 + b(v, u)));
    });
  }
}

TEST(Leak, VariesFromFrameToFrame) {
  const Plan plan = plan_of(flat_text("  - {use: leak, grey: [1, 5]}\n"));
  EXPECT_EQ(plan.render(0).at<float>(9, 9), 2.0F);
  EXPECT_EQ(plan.render(1).at<float>(9, 9), 6.0F);
}

}  // namespace
}  // namespace alltact
