#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Hole, AddsRoomLightWithinItsDisc) {
  const double mm_per_px = Camera::create(plan_of(flat_text("")).finger().camera)->mm_per_px_at(30);

  Parameters random(23);
  const cv::Mat_<float> plain = rendered(flat_text(kFaceAndLamps));
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector2d at(random.between(-20, 20), random.between(-10, 10));
    const double radius = random.between(0.1, 4), level = random.between(1, 200);
    const cv::Mat_<float> got = rendered(
        flat_text(kFaceAndLamps +
                  fmt::format("  - {{use: hole, s_mm: {}, y_mm: {}, radius_mm: {}, level: {}}}\n",
                              at.x(), at.y(), radius, level)));
    for_pixels(got.size(), 1, [&](int v, int u) {
      ASSERT_NEAR(got(v, u), plain(v, u) + level * part_of(mm_per_px, u, v, at, at, radius),
                  1e-4 * (1 + level));
    });
  }
}

}  // namespace
}  // namespace alltact
