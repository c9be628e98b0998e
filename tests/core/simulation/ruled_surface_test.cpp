// Rays side by side against the same rays one by one.
#include "core/simulation/ruled_surface.h"

#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace alltact {
namespace {

FaceCurve random_curve(std::mt19937& random) {
  std::uniform_real_distribution<double> unit(-1, 1);
  FaceCurve curve({-25, 0, 28}, 0.6 + 0.1 * unit(random), 116);
  curve.bend(6 * unit(random), 6 * unit(random));
  curve.sway(4 * unit(random));
  curve.twist(0.09 * unit(random));
  curve.integrate();
  return curve;
}

/// One row of a picture, beyond the finger's ends on both sides.
std::vector<Ray> row_of_rays(double direction_y) {
  std::vector<Ray> rays;
  for (int u = -40; u < 700; ++u) rays.push_back({{0, 0, 0}, {(u - 320) / 350.0, direction_y, 1}});
  return rays;
}

void expect_as_one_by_one(const RuledSurface& surface, const std::vector<Ray>& rays,
                          const std::vector<char>& wanted) {
  const RuledSurface::IntersectionRow row = surface.intersect_row(rays, wanted);
  int is_hit = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (wanted[i] == 0) {
      EXPECT_FALSE(row.is_hit(i)) << i;
      continue;
    }
    // Looked for alone it is found up to an eighth of the length beyond the curve's ends.
    const auto alone = surface.intersect(rays[i]);
    if (!alone) continue;
    ASSERT_TRUE(row.is_hit(i)) << i;
    ++is_hit;
    const RuledSurface::Intersection here = row.at(i);
    EXPECT_NEAR(here.s_mm, alone->s_mm, 1e-7) << i;
    EXPECT_NEAR(here.r_mm, alone->r_mm, 1e-7) << i;
    EXPECT_NEAR(here.z_mm, alone->z_mm, 1e-7) << i;
    EXPECT_LT((here.normal - alone->normal).norm(), 1e-5) << i;
    EXPECT_LT((here.point_s - alone->point_s).norm(), 1e-4) << i;
    EXPECT_LT((here.point_r - alone->point_r).norm(), 1e-4) << i;
  }
  EXPECT_GT(is_hit, 100);
}

TEST(RuledSurface, RaysSideBySideMeetItWhereOneByOneTheyDo) {
  std::mt19937 random(41);
  for (int i = 0; i < 6; ++i) {
    const FaceCurve curve = random_curve(random);
    for (const double direction_y : {-0.4, -0.02, 0.15}) {
      const std::vector<Ray> rays = row_of_rays(direction_y);
      const std::vector<char> all(rays.size(), 1);
      expect_as_one_by_one(RuledSurface::view_face(curve), rays, all);
      std::vector<char> some(rays.size(), 0);
      for (std::size_t u = 100; u < 340; ++u) some[u] = u % 53 != 0;
      expect_as_one_by_one(RuledSurface::view_face(curve), rays, some);
    }
  }
}

// What twists more within a cell than a series tells is met all the same, one by one.
TEST(RuledSurface, AStrongTwistIsMetToo) {
  FaceCurve curve({-25, 0, 28}, 0.6, 116);
  curve.bend(2, 1);
  curve.twist(0.6);
  curve.integrate();
  const std::vector<Ray> rays = row_of_rays(0.05);
  expect_as_one_by_one(RuledSurface::view_face(curve), rays, std::vector<char>(rays.size(), 1));
}

}  // namespace
}  // namespace alltact
