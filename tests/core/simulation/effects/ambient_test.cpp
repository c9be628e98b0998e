#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Ambient, IsReflectedByTheLayerLikeTheLampsLight) {
  Parameters random(4);
  for (int i = 0; i < 4; ++i) {
    const double level = random.between(1, 60), scatter = random.between(0.3, 3);
    const std::string lamps =
        fmt::format("  - {{use: layer, scatter_per_mm: {}, along: z}}\n", scatter) +
        "  - {use: leds, lamps: [{at_mm: [5, 2, 0], power: 100000}]}\n";
    const cv::Mat_<float> plain = rendered(flat_text(lamps));
    const cv::Mat_<float> lit =
        rendered(flat_text(lamps + fmt::format("  - {{use: ambient, level: {}}}\n", level)));
    const double reflected = level * scatter * 1.5 / (1 + scatter * 1.5);
    for_pixels(plain.size(), 5, [&](int v, int u) {
      EXPECT_NEAR(lit(v, u) - plain(v, u), reflected, 2e-6 * lit(v, u));
    });
  }
}

TEST(Ambient, ComesWithLamps) {
  EXPECT_THAT(refusal(flat_text("  - {use: ambient, level: 3}\n")), HasSubstr("leds too"));
  EXPECT_THAT(refusal(flat_text(kFaceAndLamps + "  - {use: ambient, level: 0}\n")),
              HasSubstr("leave it out"));
}

}  // namespace
}  // namespace alltact
