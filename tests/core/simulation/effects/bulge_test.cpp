#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

constexpr double kBallMm = 4, kDepthMm = 0.5, kShare = 0.2, kLayerMm = 1.5;

std::string pressed_text(const std::string& bulge) {
  return million_text(
      "  - {use: ball, radius_mm: 4, s_mm: 0, y_mm: 0, depth_mm: 0.5}\n  - {use: bulge, " + bulge +
      "}\n");
}

TEST(Bulge, TailsAreAsTheyAreWritten) {
  Parameters random(31);
  for (int i = 0; i < 4; ++i) {
    const double width = random.between(0.3, 0.9), steepness = random.between(0.8, 4);
    const bool is_exponential = i > 0;
    const std::string tail =
        is_exponential ? fmt::format(", tail: exponential, steepness: {}", steepness) : "";
    const Truth truth =
        plan_of(pressed_text(fmt::format("share: {}, width_mm: {}{}", kShare, width, tail)))
            .truth(0);
    const double rim = std::sqrt(kDepthMm * (2 * kBallMm - kDepthMm));
    int compared = 0;
    for (int u = 500; u < 1000; u += 7) {
      const double r = 0.01 * (u - 500);
      if (r < rim + 0.01) continue;
      const double q = (r - rim) / width;
      const double ring =
          is_exponential ? std::pow(q * std::exp(1 - q), steepness) : q * q * std::exp(1 - q * q);
      EXPECT_NEAR(truth.depth_mm.at<float>(500, u), -kShare * kLayerMm * ring, 1e-4) << q;
      ++compared;
    }
    EXPECT_GT(compared, 30);
  }
}

TEST(Bulge, AnExponentialTailNeedsItsSteepness) {
  EXPECT_THAT(refusal(pressed_text("share: 0.1, width_mm: 1, tail: exponential")),
              HasSubstr("steepness"));
  EXPECT_THAT(refusal(pressed_text("share: 0.1, width_mm: 1, steepness: 2")),
              HasSubstr("steepness"));
}

}  // namespace
}  // namespace alltact
