// Meshes of bodies by their formulas.
#pragma once

#include "core/base/atomic_file.h"
#include "core/mesh/mesh_file.h"

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include <Eigen/Core>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace alltact::test {

/// Turns a profile (y, z; counter-clockwise seen from +x) into a prism along x.
inline TriangleMesh prism(const std::vector<Eigen::Vector2d>& profile, double half_mm) {
  TriangleMesh mesh;
  const int n = static_cast<int>(profile.size());
  for (const double x : {-half_mm, half_mm})
    for (const Eigen::Vector2d& at : profile) mesh.points.emplace_back(x, at.x(), at.y());
  for (int i = 0; i < n; ++i) {
    const int k = (i + 1) % n;
    mesh.triangles.push_back({i, i + n, k});
    mesh.triangles.push_back({k, i + n, k + n});
    if (i < 2) continue;
    mesh.triangles.push_back({0, i - 1, i});
    mesh.triangles.push_back({n, n + i, n + i - 1});
  }
  return mesh;
}

/// Along x.
inline TriangleMesh rod(double radius_mm, double half_mm) {
  std::vector<Eigen::Vector2d> circle;
  for (int i = 0; i < 240; ++i)
    circle.emplace_back(radius_mm * std::cos(M_PI * i / 120), radius_mm * std::sin(M_PI * i / 120));
  return prism(circle, half_mm);
}

/// Its ridge is the x axis; its flanks fall by `slope` in z.
inline TriangleMesh ridge(double slope) {
  return prism({{8, -8 * slope}, {0, 0}, {-8, -8 * slope}, {-8, -20}, {8, -20}}, 25);
}

inline TriangleMesh ball(double radius_mm) {
  TriangleMesh mesh;
  constexpr int kRings = 90, kAround = 180;
  mesh.points.emplace_back(0, 0, radius_mm);
  for (int i = 1; i < kRings; ++i)
    for (int k = 0; k < kAround; ++k) {
      const double polar = M_PI * i / kRings, turn = 2 * M_PI * k / kAround;
      mesh.points.emplace_back(radius_mm * std::sin(polar) * std::cos(turn),
                               radius_mm * std::sin(polar) * std::sin(turn),
                               radius_mm * std::cos(polar));
    }
  mesh.points.emplace_back(0, 0, -radius_mm);
  const auto at = [](int ring, int k) { return 1 + (ring - 1) * kAround + k % kAround; };
  const int last = static_cast<int>(mesh.points.size()) - 1;
  for (int k = 0; k < kAround; ++k) {
    mesh.triangles.push_back({0, at(1, k), at(1, k + 1)});
    mesh.triangles.push_back({last, at(kRings - 1, k + 1), at(kRings - 1, k)});
    for (int i = 1; i + 1 < kRings; ++i) {
      mesh.triangles.push_back({at(i, k), at(i + 1, k), at(i, k + 1)});
      mesh.triangles.push_back({at(i, k + 1), at(i + 1, k), at(i + 1, k + 1)});
    }
  }
  return mesh;
}

/// A text STL.
inline void write_stl(const std::filesystem::path& file, const TriangleMesh& mesh) {
  std::string text = "solid body\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int corner : triangle) {
      const Eigen::Vector3d& at = mesh.points[static_cast<std::size_t>(corner)];
      text += fmt::format("vertex {} {} {}\n", at.x(), at.y(), at.z());
    }
    text += "endloop\nendfacet\n";
  }
  ASSERT_TRUE(write_file_atomically(file, text + "endsolid body\n").ok());
}

}  // namespace alltact::test
