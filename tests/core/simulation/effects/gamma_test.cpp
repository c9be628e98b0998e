#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Gamma, IsThePowerLaw) {
  Parameters random(13);
  const std::string effects = kFaceAndLamps + "  - {use: read, sd: 3}\n";
  const cv::Mat_<float> plain = rendered(scene_text(effects));
  for (const double gamma :
       {0.1, 0.45, 2.2, 10.0, random.between(0.3, 4), random.between(0.3, 4)}) {
    const cv::Mat_<float> got =
        rendered(scene_text(effects + fmt::format("  - {{use: gamma, gamma: {}}}\n", gamma)));
    for_pixels(plain.size(), 1, [&](int v, int u) {
      const double expected = 255 * std::pow(std::max(0.0, plain(v, u) / 255.0), 1 / gamma);
      ASSERT_NEAR(got(v, u), expected, 4e-6 / std::min(gamma, 1.0) * expected + 1e-6);
    });
  }
  EXPECT_THAT(refusal(scene_text("  - {use: gamma, gamma: 1}\n")), HasSubstr("leave gamma out"));
}

}  // namespace
}  // namespace alltact
