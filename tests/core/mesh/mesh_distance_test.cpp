#include "core/mesh/mesh_distance.h"

#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace alltact::test {
namespace {

/// An axis-parallel block with a corner at the origin.
TriangleMesh block(const Eigen::Vector3d& size) {
  TriangleMesh mesh;
  for (int i = 0; i < 8; ++i)
    mesh.points.emplace_back(size.x() * (i & 1), size.y() * (i >> 1 & 1), size.z() * (i >> 2));
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

/// Signed distance from that block, by the formula.
double distance_from_block(const Eigen::Vector3d& point, const Eigen::Vector3d& size) {
  const Eigen::Vector3d off = (point - 0.5 * size).cwiseAbs() - 0.5 * size;
  return off.cwiseMax(0.0).norm() + std::min(0.0, off.maxCoeff());
}

TEST(MeshDistance, OfABlockIsItsFormula) {
  const Eigen::Vector3d size(2, 3, 0.5);
  for (const bool is_inside_out : {false, true}) {
    TriangleMesh mesh = block(size);
    if (is_inside_out)
      for (auto& corners : mesh.triangles) std::swap(corners[0], corners[1]);
    const auto distance = MeshDistance::create(mesh);
    ASSERT_TRUE(distance.ok()) << distance.error().sentence();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> around(-1.5, 4.0);
    for (int i = 0; i < 3000; ++i) {
      const Eigen::Vector3d point(around(random), around(random), around(random) - 0.5);
      const auto nearest = (*distance)(point);
      EXPECT_NEAR(nearest.distance, distance_from_block(point, size), 1e-12);
      EXPECT_NEAR(nearest.outwards.norm(), 1, 1e-12);
      // The gradient of the distance.
      EXPECT_NEAR((*distance)(point + 1e-6 * nearest.outwards).distance, nearest.distance + 1e-6,
                  1e-9);
    }
  }
}

TEST(MeshDistance, OnTheSurfaceTheNormalPointsOutwards) {
  const auto distance = MeshDistance::create(block({1, 1, 1}));
  const Eigen::Vector3d on_top(0.3, 0.6, 1), at_corner(1, 1, 1), on_edge(1, 0.5, 1);
  EXPECT_LT(((*distance)(on_top).outwards - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT(((*distance)(at_corner).outwards - Eigen::Vector3d::Ones().normalized()).norm(), 1e-9);
  EXPECT_LT(((*distance)(on_edge).outwards - Eigen::Vector3d(1, 0, 1).normalized()).norm(), 1e-9);
  EXPECT_EQ((*distance)(on_top).distance, 0);
}

TEST(MeshDistance, OpenAndFlatMeshesAreRefused) {
  TriangleMesh open = block({1, 1, 1});
  open.triangles.pop_back();
  EXPECT_FALSE(MeshDistance::create(open).ok());
  TriangleMesh flat = block({1, 1, 0});
  EXPECT_FALSE(MeshDistance::create(flat).ok());
}

}  // namespace
}  // namespace alltact::test
