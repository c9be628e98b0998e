#include "tests/core/simulation/effects/moving_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(RollingShutter, TakesEveryRowAtItsOwnTime) {
  Parameters random(19);
  for (int i = 0; i < 2; ++i) {
    const double readout_ms = random.between(10, 50);
    const Plan plan =
        plan_of(moving(fmt::format("  - {{use: rolling-shutter, readout_ms: {}}}\n", readout_ms)));
    const cv::Mat_<float> got = plan.render(1);
    for (const int v : {0, 13, 60, 89, 90, 130, 179}) {
      const cv::Mat_<float> still = still_at(1 + readout_ms / 50 * (v / 179.0 - 0.5));
      EXPECT_LT(cv::norm(got.row(v), still.row(v), cv::NORM_INF), 0.002) << v;
    }
    EXPECT_GT(cv::norm(got, still_at(1), cv::NORM_INF), 0.5);
    EXPECT_EQ(cv::norm(got, plan.render(1, 3), cv::NORM_INF), 0);
  }
}

TEST(RollingShutter, RowsMayShareAMoment) {
  const Plan plan =
      plan_of(moving("  - {use: rolling-shutter, readout_ms: 40, rows_at_once: 16}\n"));
  const cv::Mat_<float> got = plan.render(1);
  for (const int v : {0, 15, 16, 100, 179}) {
    const int band = v / 16 * 16, last = std::min(band + 15, 179);
    const cv::Mat_<float> still = still_at(1 + 0.8 * ((band + last) / 2.0 / 179 - 0.5));
    EXPECT_LT(cv::norm(got.row(v), still.row(v), cv::NORM_INF), 0.002) << v;
  }
  for (const int threads : {2, 3, 7})
    EXPECT_EQ(cv::norm(got, plan.render(1, threads), cv::NORM_INF), 0);
}

// Together with motion blur every row is the mean about its own time.
TEST(RollingShutter, GoesTogetherWithMotionBlur) {
  const cv::Mat_<float> got =
      plan_of(moving("  - {use: rolling-shutter, readout_ms: 25}\n"
                     "  - {use: motion-blur, exposure_ms: 20, moments: 2}\n"))
          .render(1);
  for (const int v : {0, 50, 120}) {
    const double row = 1 + 0.5 * (v / 179.0 - 0.5);
    const cv::Mat_<float> early = still_at(row - 0.1), late = still_at(row + 0.1);
    for (int u = 0; u < 320; ++u) EXPECT_NEAR(got(v, u), (early(v, u) + late(v, u)) / 2, 0.002);
  }
  EXPECT_THAT(refusal(moving("  - {use: rolling-shutter, readout_ms: 51}\n")),
              HasSubstr("readout_ms up to 50"));
}

}  // namespace
}  // namespace alltact
