#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

using testing::HasSubstr;

/// Share of the pixel within `radius` of the line from a to b, of the flat face.
double part_of(
    double mm_per_px, int u, int v, Eigen::Vector2d a, Eigen::Vector2d b, double radius) {
  const Eigen::Vector2d p = flat_point(u, v).head<2>();
  double nearest = std::min((p - a).norm(), (p - b).norm());
  const double length = (b - a).norm();
  if (length > 0) {
    const Eigen::Vector2d way = (b - a) / length;
    const double along = (p - a).dot(way);
    if (along > 0 && along < length)
      nearest = std::abs((p - a).x() * way.y() - (p - a).y() * way.x());
  }
  return std::clamp((radius - nearest) / mm_per_px + 0.5, 0.0, 1.0);
}

TEST(Scratch, ChangesTheLightAlongItsLine) {
  const double mm_per_px = Camera::create(plan_of(flat_text("")).finger().camera)->mm_per_px_at(30);

  Parameters random(22);
  for (int i = 0; i < 5; ++i) {
    const Eigen::Vector2d a(random.between(-20, 20), random.between(-10, 10));
    const Eigen::Vector2d b(random.between(-20, 20), random.between(-10, 10));
    const double width = random.between(0.1, 2), change = random.between(-1, 3);
    const cv::Mat_<float> got = rendered(flat_text(fmt::format(
        "  - {{use: scratch, from_mm: [{}, {}], to_mm: [{}, {}], width_mm: {}, change: {}}}\n",
        a.x(),
        a.y(),
        b.x(),
        b.y(),
        width,
        change)));
    for_pixels(got.size(), 1, [&](int v, int u) {
      ASSERT_NEAR(got(v, u), 1 + change * part_of(mm_per_px, u, v, a, b, width / 2), 2e-4);
    });
  }
}

}  // namespace
}  // namespace alltact
