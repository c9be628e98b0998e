#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Glare, IsThePowerOfTheHalfwayAngle) {
  Parameters random(7);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector3d lamp(random.between(-40, 40), random.between(-20, 20),
                               random.between(-10, 20));
    const double level = random.between(1, 200), sharpness = random.between(1, 200);
    const cv::Mat_<float> image = rendered(
        flat_text(fmt::format("  - {{use: glare, at_mm: [{}, {}, {}], level: {}, sharpness: {}}}\n",
                              lamp.x(), lamp.y(), lamp.z(), level, sharpness)));
    for_pixels(image.size(), 3, [&](int v, int u) {
      const Eigen::Vector3d p = flat_point(u, v);
      const Eigen::Vector3d half = (lamp - p).normalized() + (-p).normalized();
      const double expected = level * std::pow(std::max(0.0, -half.normalized().z()), sharpness);
      EXPECT_NEAR(image(v, u) - 1, expected, 3e-7 + 2e-6 * sharpness * expected);
    });
  }
}

TEST(Glare, ComesBackAlongAnOrthographicRay) {
  const cv::Mat_<float> image =
      rendered(million_text("  - {use: glare, at_mm: [2, 1, 0], level: 100, sharpness: 50}\n"));
  for_pixels(image.size(), 97, [&](int v, int u) {
    const Eigen::Vector3d p((u - 500) * 0.01, (v - 500) * 0.01, 30);
    const Eigen::Vector3d half =
        (Eigen::Vector3d(2, 1, 0) - p).normalized() - Eigen::Vector3d::UnitZ();
    EXPECT_NEAR(image(v, u), 1 + 100 * std::pow(-half.normalized().z(), 50), 5e-3);
  });
}

}  // namespace
}  // namespace alltact
