#include "tests/core/simulation/effects/effect_scene.h"

namespace alltact {
namespace {

// Where a pixel's ray meets the plane of a side, as long as that is within the body.
TEST(Sides, AreSeenWhereRaysMeetThem) {
  Parameters random(37);
  int beside = 0;
  for (int i = 0; i < 5; ++i) {
    const double albedo = random.between(0.02, 0.9), deep = random.between(4, 25);
    const double incline = random.between(15, 45) * M_PI / 180;
    std::string text =
        scene_text(fmt::format("  - {{use: sides, albedo: {}, depth_mm: {}}}\n", albedo, deep));
    text.replace(text.find("incline_deg: 34.0"), 17,
                 fmt::format("incline_deg: {}", incline * 180 / M_PI));
    const cv::Mat_<float> got = rendered(text);
    const Eigen::Vector3d base(-25, 0, 28), along(std::cos(incline), 0, std::sin(incline));
    const Eigen::Vector3d normal(-std::sin(incline), 0, std::cos(incline));
    int seen = 0;
    for_pixels(got.size(), 3, [&](int v, int u) {
      const Eigen::Vector3d ray((u - 158.5) / 170, (v - 90.25) / 172, 1);
      const double facing = ray.dot(normal);
      if (facing < 0.1 || std::abs(ray.y()) < 0.05) return;
      const double to_face = base.dot(normal) / facing, to_side = 12 / std::abs(ray.y());
      const double mm_per_px = to_side / 170;
      if (std::abs(to_face - to_side) * std::abs(ray.y()) < 3 * mm_per_px) return;
      const Eigen::Vector3d face = to_face * ray - base, p = to_side * ray - base;
      const double s = p.dot(along), behind = -p.dot(normal), face_s = face.dot(along);
      // A pixel or two from an edge of the body both may be seen.
      const double margin = 3 * mm_per_px;
      if (std::min({std::abs(s), std::abs(s - 116), std::abs(behind - deep)}) < margin) return;
      if (std::min(std::abs(face_s), std::abs(face_s - 116)) < margin) return;
      const bool on_face = to_face < to_side && face_s > 0 && face_s < 116;
      if (to_face < to_side && !on_face) return;  // past the face's ends
      const bool on_side = !on_face && s > 0 && s < 116 && behind > 0 && behind < deep;
      EXPECT_NEAR(got(v, u),
                  on_face   ? 1
                  : on_side ? albedo
                            : 0,
                  1e-6)
          << u << ' ' << v << ' ' << s << ' ' << behind << ' ' << deep;
      seen += on_side;
      beside += !on_side && !on_face;
    });
    EXPECT_GT(seen, 100);
  }
  EXPECT_GT(beside, 100);
}

}  // namespace
}  // namespace alltact
