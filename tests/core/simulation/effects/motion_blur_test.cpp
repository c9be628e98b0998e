#include "tests/core/simulation/effects/moving_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(MotionBlur, IsTheMeanOfWhatIsSeenDuringTheExposure) {
  Parameters random(18);
  for (const int moments : {2, 5, 8}) {
    const double exposure_ms = random.between(5, 50);
    const Plan plan = plan_of(moving(fmt::format(
        "  - {{use: motion-blur, exposure_ms: {}, moments: {}}}\n", exposure_ms, moments)));
    for (const int frame : {0, 1}) {
      cv::Mat_<double> sum = cv::Mat_<double>::zeros(180, 320);
      for (int i = 0; i < moments; ++i) {
        const double offset = exposure_ms / 50 * ((i + 0.5) / moments - 0.5);
        cv::Mat moment;
        still_at(frame + offset).convertTo(moment, CV_64F, 1.0 / moments);
        sum += moment;
      }
      cv::Mat expected;
      sum.convertTo(expected, CV_32F);
      EXPECT_LT(cv::norm(plan.render(frame), expected, cv::NORM_INF), 0.002) << moments;
      EXPECT_EQ(cv::norm(plan.render(frame), plan.render(frame, 3), cv::NORM_INF), 0);
    }
    EXPECT_GT(cv::norm(plan.render(1), still_at(1), cv::NORM_INF), 0.5);
  }
}

TEST(MotionBlur, OfAFingerAtRestIsNothing) {
  const cv::Mat plain = plan_of(scene_text(kFaceAndLamps)).render(0);
  const cv::Mat open =
      plan_of(scene_text(kFaceAndLamps + "  - {use: motion-blur, exposure_ms: 9, moments: 4}\n"))
          .render(0);
  EXPECT_EQ(cv::norm(plain, open, cv::NORM_INF), 0);
  EXPECT_THAT(refusal(moving("  - {use: motion-blur, exposure_ms: 51}\n")),
              HasSubstr("exposure_ms up to 50"));
}

}  // namespace
}  // namespace alltact
