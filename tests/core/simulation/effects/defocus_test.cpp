#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Defocus, IsAGaussianOfTheCircleOfConfusion) {
  Parameters random(20);
  const Plan plain = plan_of(scene_text(kFaceAndLamps));
  const cv::Mat_<float> sharp = plain.render(0);
  const Truth truth = plain.truth(0);
  for (int i = 0; i < 3; ++i) {
    const double focus = random.between(25, 90), aperture = random.between(0.5, 3);
    const cv::Mat_<float> got = rendered(scene_text(
        kFaceAndLamps +
        fmt::format("  - {{use: defocus, focus_mm: {}, aperture_mm: {}}}\n", focus, aperture)));
    int compared = 0;
    for (int u = 20; u < 310; u += 23) {
      const double z = truth.view_z_mm.at<float>(90, u);
      if (std::isnan(z)) continue;
      const double sd = aperture * 170 * std::abs(1 / focus - 1 / z) / 4;
      const int half = static_cast<int>(6 * sd) + 2;
      for (int v = 0; v < 180; v += 13) {
        double sum = 0, weights = 0;
        for (int dv = -half; dv <= half; ++dv)
          for (int du = -half; du <= half; ++du) {
            const double weight = std::exp(-0.5 * (du * du + dv * dv) / (sd * sd));
            sum += weight * sharp(std::clamp(v + dv, 0, 179), std::clamp(u + du, 0, 319));
            weights += weight;
          }
        // The kernel ends at 4 times the widest column's sd.
        EXPECT_NEAR(got(v, u), sum / weights, 3e-4 * 255) << u << ' ' << v << ' ' << sd;
        ++compared;
      }
    }
    EXPECT_GT(compared, 50);
  }
}

TEST(Defocus, WhereTheFaceIsInFocusNothingChanges) {
  const cv::Mat_<float> sharp = rendered(flat_text(kFaceAndLamps));
  const cv::Mat_<float> got =
      rendered(flat_text(kFaceAndLamps + "  - {use: defocus, focus_mm: 30, aperture_mm: 2}\n"));
  EXPECT_EQ(cv::norm(sharp, got, cv::NORM_INF), 0);
  EXPECT_THAT(refusal(million_text("  - {use: defocus, focus_mm: 30, aperture_mm: 2}\n")),
              HasSubstr("orthographic"));
}

}  // namespace
}  // namespace alltact
