#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(WornMarker, FadesTheDotsItNames) {
  const std::string sides = "  - {use: sides, albedo: 0.2, depth_mm: 14}\n";
  const std::string dots =
      "  - {use: markers, radius_mm: 1.5, setback_mm: 5, first: 0.1, last: 0.9, albedo: 0.9}\n";
  const cv::Mat_<float> bare = rendered(scene_text(sides));
  const cv::Mat_<float> whole = rendered(scene_text(sides + dots));
  const auto hidden = [&](const std::string& numbers) {
    return rendered(scene_text(sides + dots + "  - {use: occlusion, markers: " + numbers + "}\n"));
  };
  Parameters random(24);
  for (int i = 0; i < 4; ++i) {
    const double wear = random.between(0.05, 1);
    const Plan plan = plan_of(scene_text(
        sides + dots + fmt::format("  - {{use: worn-marker, markers: [1, 8], wear: {}}}\n", wear)));
    const cv::Mat_<float> got = plan.render(0);
    const cv::Mat_<float> others = hidden("[1, 8]");
    for_pixels(got.size(), 1, [&](int v, int u) {
      // What the two dots add to the rest.
      const double dot = whole(v, u) - others(v, u);
      ASSERT_NEAR(got(v, u), others(v, u) + (1 - wear) * dot, 1e-6);
    });
    EXPECT_TRUE(plan.truth(0).markers[1].visible);
  }
  EXPECT_GT(cv::norm(bare, whole, cv::NORM_INF), 0.5);
  EXPECT_THAT(
      refusal(scene_text(sides + dots + "  - {use: worn-marker, markers: [12], wear: 1}\n")),
      HasSubstr("there is no marker 12"));
  EXPECT_THAT(refusal(scene_text(sides + "  - {use: worn-marker, markers: [1], wear: 1}\n")),
              HasSubstr("add the effect markers"));
}

}  // namespace
}  // namespace alltact
