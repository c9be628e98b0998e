#include "core/simulation/bodies/mesh_body.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {

namespace {

constexpr double kOnEdge = 1e-9;  // of a triangle's size: points on an edge belong to both sides

// Triangles indexed by the cells of the x-y plane that they cover.
class PosedMesh final : public PosedBody {
 public:
  PosedMesh(const TriangleMesh& mesh, const Eigen::Isometry3d& camera_from_object)
      : triangles_(mesh.triangles) {
    for (const Eigen::Vector3d& p : mesh.points) points_.push_back(camera_from_object * p);
    low_ = high_ = points_.front().head<2>();
    for (const Eigen::Vector3d& p : points_) {
      low_ = low_.cwiseMin(p.head<2>());
      high_ = high_.cwiseMax(p.head<2>());
    }
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(triangles_.size()))), 1, 512);
    fill_cells();
  }

  double lowest_z_mm(double x_mm, double y_mm, double below_mm) const override {
    double lowest = std::numeric_limits<double>::infinity();
    const Eigen::Vector2d at(x_mm, y_mm);
    if ((at.array() < low_.array()).any() || (at.array() > high_.array()).any()) return lowest;
    const auto cell = static_cast<std::size_t>(cell_of(y_mm, 1) * side_ + cell_of(x_mm, 0));
    for (std::size_t i = starts_[cell]; i < starts_[cell + 1]; ++i)
      lowest = std::min(lowest, z_over(triangles_[static_cast<std::size_t>(in_cells_[i])], at));
    return lowest < below_mm ? lowest : std::numeric_limits<double>::infinity();
  }

 private:
  [[nodiscard]] int cell_of(double value, int axis) const {
    const double part = (value - low_[axis]) / std::max(high_[axis] - low_[axis], 1e-12);
    return std::clamp(static_cast<int>(part * side_), 0, side_ - 1);
  }

  template <class Visit>
  void over_cells(const std::array<int, 3>& triangle, const Visit& visit) const {
    Eigen::Vector2d low = point(triangle[0]).head<2>(), high = low;
    for (const int corner : triangle) {
      low = low.cwiseMin(point(corner).head<2>());
      high = high.cwiseMax(point(corner).head<2>());
    }
    for (int row = cell_of(low.y(), 1); row <= cell_of(high.y(), 1); ++row)
      for (int column = cell_of(low.x(), 0); column <= cell_of(high.x(), 0); ++column)
        visit(static_cast<std::size_t>(row * side_ + column));
  }

  // The entries are counted first, so that all lists share one array.
  void fill_cells() {
    starts_.assign(static_cast<std::size_t>(side_ * side_) + 1, 0);
    for (const auto& triangle : triangles_)
      over_cells(triangle, [&](std::size_t cell) { ++starts_[cell + 1]; });
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    in_cells_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      over_cells(triangles_[i],
                 [&](std::size_t cell) { in_cells_[next[cell]++] = static_cast<int>(i); });
  }

  [[nodiscard]] const Eigen::Vector3d& point(int number) const {
    return points_[static_cast<std::size_t>(number)];
  }

  // Returns infinity outside the triangle and for a triangle viewed edge on.
  [[nodiscard]] double z_over(const std::array<int, 3>& triangle, const Eigen::Vector2d& at) const {
    const Eigen::Vector3d& a = point(triangle[0]);
    const Eigen::Vector3d b = point(triangle[1]) - a, c = point(triangle[2]) - a;
    const Eigen::Vector2d p = at - a.head<2>();
    const double area = b.x() * c.y() - b.y() * c.x();
    if (std::abs(area) < 1e-14) return std::numeric_limits<double>::infinity();
    const double of_b = (p.x() * c.y() - p.y() * c.x()) / area;
    const double of_c = (b.x() * p.y() - b.y() * p.x()) / area;
    const bool is_outside = of_b < -kOnEdge || of_c < -kOnEdge || of_b + of_c > 1 + kOnEdge;
    return is_outside ? std::numeric_limits<double>::infinity()
                      : a.z() + of_b * b.z() + of_c * c.z();
  }

  const std::vector<std::array<int, 3>>& triangles_;
  std::vector<Eigen::Vector3d> points_;
  Eigen::Vector2d low_, high_;
  int side_ = 1;
  std::vector<std::size_t> starts_;
  std::vector<int> in_cells_;
};

}  // namespace

MeshBody::MeshBody(TriangleMesh mesh, double scale) : mesh_(std::move(mesh)) {
  Eigen::AlignedBox3d box;
  for (Eigen::Vector3d& p : mesh_.points) {
    p *= scale;
    box.extend(p);
  }
  const Eigen::Vector3d origin(box.center().x(), box.center().y(), box.min().z());
  for (Eigen::Vector3d& p : mesh_.points) p -= origin;
  half_size_mm_ = box.sizes().head<2>() / 2;
}

std::unique_ptr<const PosedBody> MeshBody::posed(
    const Eigen::Isometry3d& camera_from_object) const {
  return std::make_unique<PosedMesh>(mesh_, camera_from_object);
}

double MeshBody::min_along_mm(const Eigen::Vector3d& direction) const {
  double min_value = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : mesh_.points) min_value = std::min(min_value, direction.dot(p));
  return min_value;
}

}  // namespace alltact
