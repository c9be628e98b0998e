#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

double mean_of(const cv::Mat_<float>& image) {
  double sum = 0;
  for (const float value : image) sum += value;
  return sum / static_cast<double>(image.total());
}

TEST(AutomaticExposure, BringsTheMeanToItsTarget) {
  Parameters random(17);
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  const double mean = mean_of(plain);
  for (int i = 0; i < 5; ++i) {
    const double target = random.between(10, 200), share = random.between(0.1, 1);
    const cv::Mat_<float> got = rendered(scene_text(
        kFaceAndLamps +
        fmt::format("  - {{use: automatic-exposure, target: {}, share: {}}}\n", target, share)));
    const double gain = std::clamp(std::pow(target / mean, share), 0.1, 10.0);
    for_pixels(plain.size(), 3,
               [&](int v, int u) { EXPECT_NEAR(got(v, u), gain * plain(v, u), 1e-6 * got(v, u)); });
  }
  const cv::Mat_<float> settled =
      rendered(scene_text(kFaceAndLamps + "  - {use: automatic-exposure, target: 50}\n"));
  EXPECT_NEAR(mean_of(settled), 50, 1e-4);
}

TEST(AutomaticExposure, KeepsToItsRange) {
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  const cv::Mat_<float> least = rendered(
      scene_text(kFaceAndLamps + "  - {use: automatic-exposure, target: 1, least: 0.8}\n"));
  const cv::Mat_<float> most = rendered(
      scene_text(kFaceAndLamps + "  - {use: automatic-exposure, target: 255, greatest: 1.25}\n"));
  EXPECT_NEAR(least(90, 100), 0.8F * plain(90, 100), 1e-5);
  EXPECT_NEAR(most(90, 100), 1.25F * plain(90, 100), 1e-5);
}

// What a finger does to the picture changes all of it, and a frame does not depend on those that
// were rendered before.
TEST(AutomaticExposure, FollowsWhatIsSeenFrameByFrame) {
  const std::string text =
      "motion: {kind: poses, poses: [{q1_mm: 0}, {q1_mm: 5}]}\n" +
      scene_text("  - {use: bend, q1_mm: {from: -6, to: 6}, q2_mm: {from: -1, to: 1}}\n" +
                 kFaceAndLamps + "  - {use: automatic-exposure, target: 40}\n");
  const Plan plan = plan_of(text), other = plan_of(text);
  const cv::Mat first = plan.render(0), second = plan.render(1);
  EXPECT_EQ(cv::norm(other.render(1, 3), second, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(other.render(0, 2), first, cv::NORM_INF), 0);
  EXPECT_NEAR(mean_of(first), mean_of(second), 1e-4);
}

}  // namespace
}  // namespace alltact
