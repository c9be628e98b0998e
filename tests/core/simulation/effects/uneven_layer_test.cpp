#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

double wave(std::uint64_t seed, double s, double y, double length) {
  double sum = 0;
  for (std::uint32_t k = 0; k < 8; ++k) {
    const double angle = k * M_PI / 8, phase = philox_uniform(seed, "uneven-layer", 0, k);
    sum += std::cos(2 * M_PI * ((s * std::cos(angle) + y * std::sin(angle)) / length + phase));
  }
  return sum / 2;
}

TEST(UnevenLayer, WavesAboutItsThickness) {
  Parameters random(26);
  for (int i = 0; i < 4; ++i) {
    const double share = random.between(0.005, 0.1), length = random.between(3, 40);
    const std::string effect =
        fmt::format("  - {{use: uneven-layer, share: {}, length_mm: {}}}\n", share, length);
    const Plan plan =
        plan_of(flat_text("  - {use: layer, scatter_per_mm: 0.6, along: z}\n" + effect));
    const cv::Mat_<float> got = plan.render(2);
    const Truth truth = plan.truth(1);
    for_pixels(got.size(), 3, [&](int v, int u) {
      const Eigen::Vector3d p = flat_point(u, v);
      const double t = 1.5 * (1 + share * wave(effect_seed(), p.x(), p.y(), length));
      EXPECT_NEAR(truth.untouched_z_mm.at<float>(v, u), 30 + t, 1e-5);
      EXPECT_NEAR(got(v, u), 0.6 * t / (1 + 0.6 * t), 1e-5);
    });
  }
}

// A ball cuts the waving face where it lies: it stays where it is.
TEST(UnevenLayer, IsPressedWhereItLies) {
  const Truth truth =
      plan_of(flat_text("  - {use: uneven-layer, share: 0.05, length_mm: 8}\n"
                        "  - {use: ball, radius_mm: 4, s_mm: 0, y_mm: 0, depth_mm: 0.8}\n"))
          .truth(0);
  for (const int u : {150, 155, 158, 163}) {
    const Eigen::Vector3d p = flat_point(u, 90);
    const double ball = 30 + 1.5 - 0.8 + 4 - std::sqrt(16 - p.x() * p.x() - p.y() * p.y());
    EXPECT_NEAR(truth.untouched_z_mm.at<float>(90, u) - truth.depth_mm.at<float>(90, u), ball,
                1e-4);
  }
}

TEST(UnevenLayer, HasMeanZeroAndVarianceOne) {
  Moments w;
  for (std::uint64_t seed = 0; seed < 1000000; ++seed) w.add(wave(seed, 3.1, -2.2, 7));
  EXPECT_NEAR(w.mean(), 0, 4.5e-3);
  EXPECT_NEAR(w.variance(), 1, 8e-3);
}

}  // namespace
}  // namespace alltact
