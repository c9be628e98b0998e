#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(DeadPixels, AreDrawnOneByOne) {
  Parameters random(16);
  for (int i = 0; i < 4; ++i) {
    const double dead = random.between(0.002, 0.05), hot = random.between(0.002, 0.05);
    const Plan plan = plan_of(
        million_text(fmt::format("  - {{use: dead-pixels, dead: {}, hot: {}}}\n", dead, hot)));
    const cv::Mat_<float> got = plan.render(0);
    Moments black, white, per_row;
    for (int v = 0; v < got.rows; ++v) {
      int in_row = 0;
      for (int u = 0; u < got.cols; ++u) {
        const float value = got(v, u);
        ASSERT_TRUE(value == 0 || value == 1 || value == 255);
        black.add(value == 0);
        white.add(value == 255);
        in_row += value == 255;
      }
      per_row.add(in_row);
    }
    // A hot pixel outshines a dead one.
    const double seen = dead * (1 - hot);
    EXPECT_NEAR(black.mean(), seen, 4.5 * std::sqrt(seen * (1 - seen) / 1e6));
    EXPECT_NEAR(white.mean(), hot, 4.5 * std::sqrt(hot * (1 - hot) / 1e6));
    const double variance = 1000 * hot * (1 - hot);
    EXPECT_NEAR(per_row.variance(), variance, 4.5 * variance * std::sqrt(2.0 / 1000));
    EXPECT_EQ(cv::norm(got, plan.render(3, 2), cv::NORM_INF), 0);  // the same in all frames
  }
}

// The gaps of the geometric law, row by row.
TEST(DeadPixels, AreWhereTheirDrawsSay) {
  const cv::Mat_<float> got = rendered(million_text("  - {use: dead-pixels, hot: 0.01}\n"));
  for (int v = 0; v < got.rows; v += 50) {
    int at = -1;
    for (std::uint32_t i = 0;; ++i) {
      const double unit =
          philox_uniform(effect_seed(), "dead-pixels.hot", static_cast<std::uint32_t>(v), i);
      int gap = 1;  // tosses until the first that is hot
      for (double rest = 0.99; unit < rest; rest *= 0.99) ++gap;
      for (int u = at + 1; u < std::min(at + gap, 1000); ++u) ASSERT_EQ(got(v, u), 1.0F);
      at += gap;
      if (at >= 1000) break;
      ASSERT_EQ(got(v, at), 255.0F);
    }
  }
}

}  // namespace
}  // namespace alltact
