#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

TEST(Scratch, ChangesTheLightAlongItsLine) {
  const double mm_per_px = Camera::create(plan_of(flat_text("")).finger().camera)->mm_per_px_at(30);

  Parameters random(22);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector2d a(random.between(-20, 20), random.between(-10, 10));
    const Eigen::Vector2d b(random.between(-20, 20), random.between(-10, 10));
    const double width = random.between(0.1, 2), change = random.between(-1, 3);
    const cv::Mat_<float> got = rendered(flat_text(fmt::format(
        "  - {{use: scratch, from_mm: [{}, {}], to_mm: [{}, {}], width_mm: {}, change: {}}}\n",
        a.x(), a.y(), b.x(), b.y(), width, change)));
    for_pixels(got.size(), 1, [&](int v, int u) {
      ASSERT_NEAR(got(v, u), 1 + change * part_of(mm_per_px, u, v, a, b, width / 2), 2e-4);
    });
  }
}

}  // namespace
}  // namespace alltact
