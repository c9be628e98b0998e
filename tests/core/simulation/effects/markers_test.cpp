#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

// The dots' areas in the picture, by the brightness that they add.
TEST(Markers, GrowFromTheFirstToTheLast) {
  const std::string camera =
      "model: pinhole, size: [1920, 1080], fx: 1020, fy: 1020, cx: 951, cy: 539";
  const std::string sides = "  - {use: sides, albedo: 0.1, depth_mm: 20}\n";
  const auto dots = [](const std::string& more) {
    return "  - {use: markers, radius_mm: 1.2, setback_mm: 5, first: 0.1, last: 0.9, albedo: 1" +
           more + "}\n";
  };
  Parameters random(25);
  const cv::Mat_<float> bare = rendered(scene_text(sides, camera));
  for (int k = 0; k < 2; ++k) {
    const double last = random.between(0.6, 3);
    const Plan plan =
        plan_of(scene_text(sides + dots(fmt::format(", last_radius_mm: {}", last)), camera));
    const cv::Mat_<float> got = plan.render(0);
    const Truth truth = plan.truth(0);
    for (int i = 0; i < 6; ++i) {
      const double s = 116 * (0.1 + 0.16 * i), theta = 34 * M_PI / 180;
      const double z = 28 + s * std::sin(theta) - 5 * std::cos(theta);
      const double radius = 1.2 + (last - 1.2) * i / 5;
      const auto& dot = truth.markers[static_cast<std::size_t>(i)];
      const double reach_u = 1.3 * 1020 * radius / z + 2,
                   reach_v = 1.3 * 1020 * radius * 12 / z / z + 2;
      double area = 0;
      for (int v = 0; v < got.rows; ++v)
        for (int u = 0; u < got.cols; ++u)
          if (std::abs(u - dot.u) < reach_u * 1.2 && std::abs(v - dot.v) < reach_v * 1.2)
            area += (got(v, u) - bare(v, u)) / 0.9;
      const double expected = M_PI * radius * radius * 1020 * 1020 * 12 / (z * z * z);
      EXPECT_NEAR(area / expected, 1, 0.04) << i << ' ' << radius;
    }
  }
  const cv::Mat same = plan_of(scene_text(sides + dots(", last_radius_mm: 1.2"), camera)).render(0);
  EXPECT_EQ(cv::norm(same, rendered(scene_text(sides + dots(""), camera)), cv::NORM_INF), 0);
  EXPECT_THAT(refusal(scene_text(sides + dots(", last_radius_mm: 5"))), HasSubstr("cut the face"));
}

TEST(Markers, StepsGrowByOneFactor) {
  const Truth truth =
      plan_of(scene_text("  - {use: sides, albedo: 0.1, depth_mm: 20}\n"
                         "  - {use: markers, radius_mm: 0.2, setback_mm: 5, first: 0.1, last: 0.9, "
                         "albedo: 1, step_ratio: 3}\n"))
          .truth(0);
  // Back from the picture to places along the face's straight line.
  const double theta = 34 * M_PI / 180;
  std::vector<double> s_mm;
  for (int i = 0; i < 6; ++i) {
    const double x = (truth.markers[static_cast<std::size_t>(i)].u - 158.5) / 170;
    const double z0 = 28 - 5 * std::cos(theta), x0 = -25 + 5 * std::sin(theta);
    s_mm.push_back((x * z0 - x0) / (std::cos(theta) - x * std::sin(theta)));
  }
  EXPECT_NEAR(s_mm.front(), 11.6, 0.01);
  EXPECT_NEAR(s_mm.back(), 104.4, 0.03);
  const double first = s_mm[1] - s_mm[0];
  for (std::size_t i = 1; i < 5; ++i)
    EXPECT_NEAR((s_mm[i + 1] - s_mm[i]) / first, std::pow(3, i / 4.0), 0.01);
}

}  // namespace
}  // namespace alltact
