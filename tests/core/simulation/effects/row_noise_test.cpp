#include "core/simulation/noise.h"
#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(RowNoiseEffect, ShiftsEveryRowOfEveryFrameOnItsOwn) {
  const Plan plan =
      plan_of(flat_text("  - {use: row-noise, sd: 0.7}\n",
                        "model: orthographic, size: [16, 16384], mm_per_px: 0.01, cx: 8, cy: 8"));
  const RowNoise noise("row-noise");
  Moments draws;
  for (int frame = 0; frame < 62; ++frame) {
    const cv::Mat_<float> got = plan.render(frame);
    for (int v = 0; v < got.rows; ++v) {
      ASSERT_EQ(got(v, 0), got(v, 15));
      draws.add(got(v, 0));
      if (v % 999 != 0) continue;
      float n = 0;
      noise.normals(effect_seed(), frame, v, 1, &n);
      EXPECT_NEAR(got(v, 3), 1 + 0.7 * n, 1e-6);
    }
  }
  expect_normal(draws, 1, 0.7);
}

}  // namespace
}  // namespace alltact
