#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Vignetting, IsTheFourthPowerOfTheCosine) {
  const cv::Mat_<float> plain = rendered(scene_text(kFaceAndLamps));
  const cv::Mat_<float> dark =
      rendered(scene_text(kFaceAndLamps + "  - {use: vignetting, kind: cos4}\n"));
  for_pixels(plain.size(), 3, [&](int v, int u) {
    const double x = (u - 158.5) / 170, y = (v - 90.25) / 172;
    const double cos = 1 / std::sqrt(1 + x * x + y * y);
    EXPECT_NEAR(dark(v, u), plain(v, u) * std::pow(cos, 4), 1e-6 * plain(v, u));
  });
}

TEST(Vignetting, FollowsTheRaysOfACameraWithDistortion) {
  const std::string camera =
      "model: brown, size: [320, 180], fx: 200, fy: 201, cx: 158.5, cy: 90.25";
  const Plan plan =
      plan_of(flat_text("  - {use: vignetting, kind: cos4}\n"
                        "  - {use: distortion, coefficients: [-0.12, 0.02, 0.001, -0.0005, 0.0]}\n",
                        camera));
  const cv::Mat_<float> dark = plan.render(0);
  const auto lens = Camera::create(plan.finger().camera);
  ASSERT_TRUE(lens);
  for_pixels(dark.size(), 7, [&](int v, int u) {
    const auto ray = lens->unproject({static_cast<double>(u), static_cast<double>(v)});
    ASSERT_TRUE(ray);
    EXPECT_NEAR(dark(v, u), std::pow(ray->direction.normalized().z(), 4), 1e-6);
  });
}

TEST(Vignetting, IsThePolynomialOfTheRadius) {
  Parameters random(3);
  for (int i = 0; i < 5; ++i) {
    const double a = random.between(-0.5, 0), b = random.between(-0.2, 0.2),
                 c = random.between(-0.1, 0.2);
    const cv::Mat_<float> dark = rendered(flat_text(fmt::format(
        "  - {{use: vignetting, kind: polynomial, coefficients: [{}, {}, {}]}}\n", a, b, c)));
    const double farthest2 = 160.5 * 160.5 + 90.25 * 90.25;
    for_pixels(dark.size(), 3, [&](int v, int u) {
      const double r2 = (std::pow(u - 158.5, 2) + std::pow(v - 90.25, 2)) / farthest2;
      EXPECT_NEAR(dark(v, u), 1 + a * r2 + b * r2 * r2 + c * r2 * r2 * r2, 1e-6);
    });
  }
}

TEST(Vignetting, RefusesWhatCannotBe) {
  EXPECT_THAT(refusal(flat_text("  - {use: vignetting, kind: polynomial, coefficients: [-1.5]}\n")),
              HasSubstr("would have no light"));
  EXPECT_THAT(refusal(million_text("  - {use: vignetting, kind: cos4}\n")),
              HasSubstr("orthographic"));
}

}  // namespace
}  // namespace alltact
