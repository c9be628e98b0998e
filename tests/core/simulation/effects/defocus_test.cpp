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

TEST(Defocus, ItsSdCanBeNamedForAnyCamera) {
  const std::string camera =
      "model: orthographic, size: [320, 180], mm_per_px: 0.1, cx: 158.5, cy: 90.25";
  const std::string ball =
      kFaceAndLamps + "  - {use: ball, radius_mm: 4, s_mm: 0, y_mm: 0, depth_mm: 0.9}\n";
  const cv::Mat_<float> sharp = rendered(flat_text(ball, camera));
  Parameters random(21);
  for (int i = 0; i < 3; ++i) {
    const double sd = random.between(0.4, 3);
    const cv::Mat_<float> got =
        rendered(flat_text(ball + fmt::format("  - {{use: defocus, sd_px: {}}}\n", sd), camera));
    for (int u = 100; u < 220; u += 9) {
      double sum = 0, weights = 0;
      for (int dv = -20; dv <= 20; ++dv)
        for (int du = -20; du <= 20; ++du) {
          const double weight = std::exp(-0.5 * (du * du + dv * dv) / (sd * sd));
          sum += weight * sharp(90 + dv, u + du);
          weights += weight;
        }
      EXPECT_NEAR(got(90, u), sum / weights, 3e-4 * 255) << u << ' ' << sd;
    }
  }
}

}  // namespace
}  // namespace alltact
