#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Speck, DarkensItsDisc) {
  const double mm_per_px = Camera::create(plan_of(flat_text("")).finger().camera)->mm_per_px_at(30);

  Parameters random(21);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector2d at(random.between(-20, 20), random.between(-10, 10));
    const double radius = random.between(0.1, 4), darkness = random.between(0.1, 1);
    const cv::Mat_<float> got = rendered(flat_text(
        fmt::format("  - {{use: speck, s_mm: {}, y_mm: {}, radius_mm: {}, darkness: {}}}\n", at.x(),
                    at.y(), radius, darkness)));
    double lost = 0;
    for_pixels(got.size(), 1, [&](int v, int u) {
      ASSERT_NEAR(got(v, u), 1 - darkness * part_of(mm_per_px, u, v, at, at, radius), 1e-4);
      lost += 1 - got(v, u);
    });
    if (radius > 0.5) {
      const double disc_px = M_PI * radius * radius / (30.0 / 170 * 30.0 / 172);
      EXPECT_NEAR(lost, darkness * disc_px, 0.02 * disc_px);
    }
  }
}

TEST(Speck, LiesOnTheFaceOfABentFinger) {
  const std::string speck = "  - {use: speck, s_mm: 40, y_mm: 3, radius_mm: 3, darkness: 1}\n";
  const cv::Mat_<float> got = rendered(scene_text(speck));
  // s = 40 of a straight face that starts at (-25, 28) and rises by 34 degrees.
  const double x = -25 + 40 * std::cos(34 * M_PI / 180), z = 28 + 40 * std::sin(34 * M_PI / 180);
  const int u = static_cast<int>(std::lround(158.5 + 170 * x / z));
  const int v = static_cast<int>(std::lround(90.25 + 172 * 3 / z));
  EXPECT_EQ(got(v, u), 0.0F);
  EXPECT_EQ(got(v - 20, u), 1.0F);
  EXPECT_THAT(
      refusal(scene_text("  - {use: speck, s_mm: 40, y_mm: 13, radius_mm: 3, darkness: 1}\n")),
      HasSubstr("outside the face"));
}

}  // namespace
}  // namespace alltact
