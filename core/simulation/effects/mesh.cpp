// A body given by triangles.
#include "core/base/program.h"
#include "core/mesh/mesh_file.h"
#include "core/simulation/press.h"
#include "core/simulation/rigid_press.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace alltact {
namespace {

/// The mesh in mm. Its bounding box is centred over the origin and its lowest points lie at z = 0.
/// Its facets are flat: a curved surface is only as smooth as the mesh.
class MeshBody final : public Body {
 public:
  /// `mesh` is closed. `scale`: mm per unit of the file.
  MeshBody(TriangleMesh mesh, double scale);

  [[nodiscard]] PosedBody posed(const Eigen::Isometry3d& camera_from_object) const override;
  [[nodiscard]] double min_along_mm(const Eigen::Vector3d& direction) const override;
  [[nodiscard]] Eigen::Vector2d half_size_mm() const override { return half_size_mm_; }

 private:
  TriangleMesh mesh_;
  Eigen::Vector2d half_size_mm_;
};

constexpr double kOnEdge = 1e-9;  // of a triangle's size: points on an edge belong to both sides

// Triangles indexed by the cells of the x-y plane that they cover.
class PosedMesh {
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

  [[nodiscard]] double lowest_z_mm(double x_mm, double y_mm, double below_mm) const {
    double lowest = std::numeric_limits<double>::infinity();
    const Eigen::Vector2d at(x_mm, y_mm);
    if ((at.array() < low_.array()).any() || (at.array() > high_.array()).any()) return lowest;
    const auto cell =
        static_cast<std::size_t>(std::ptrdiff_t{cell_of(y_mm, 1)} * side_ + cell_of(x_mm, 0));
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
        visit(static_cast<std::size_t>(std::ptrdiff_t{row} * side_ + column));
  }

  // The entries are counted first, so that all lists share one array.
  void fill_cells() {
    starts_.assign(static_cast<std::size_t>(std::ptrdiff_t{side_} * side_) + 1, 0);
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

PosedBody MeshBody::posed(const Eigen::Isometry3d& camera_from_object) const {
  return [mesh = std::make_shared<const PosedMesh>(mesh_, camera_from_object)](
             double x_mm, double y_mm, double below_mm) {
    return mesh->lowest_z_mm(x_mm, y_mm, below_mm);
  };
}

double MeshBody::min_along_mm(const Eigen::Vector3d& direction) const {
  double min_value = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& p : mesh_.points) min_value = std::min(min_value, direction.dot(p));
  return min_value;
}

// A body given by triangles: `file` (STL or OBJ, next to the scene, or one in resources/bodies),
// `scale` in mm per unit of the file. Unless rotated, its z axis points away from the finger and
// its x axis along it. Its centre lies over the press position.

constexpr double kMaxSize_mm = 1000, kMinSize_mm = 0.1;

std::filesystem::path find_mesh(const std::filesystem::path& folder, const std::string& name) {
  const std::filesystem::path local_file = folder / name;
  std::error_code failed;
  if (std::filesystem::exists(local_file, failed)) return local_file;
  const auto shipped = find_resource(std::filesystem::path("bodies") / name);
  return shipped ? *shipped : local_file;
}

std::shared_ptr<const Body> mesh_body(YamlSection& p) {
  const double scale = p.number_or("scale", 1, strength_up_to(1e6));
  auto mesh = read_mesh(find_mesh(p.file().path().parent_path(), p.text("file")));
  if (!mesh) p.refuse("file", mesh.error().what, mesh.error().advice);
  if (const Status closed = check_closed(*mesh); !closed)
    p.refuse("file", closed.error().what, closed.error().advice);
  auto body = std::make_shared<MeshBody>(std::move(*mesh), scale);
  const double size = 2 * body->half_size_mm().maxCoeff();
  if (size > kMaxSize_mm || size < kMinSize_mm)
    p.refuse(p.has("scale") ? "scale" : "file", en::say("the body would be {:g} mm in size", size),
             en::say("'scale' specifies the mm per unit of the file"));
  return body;
}

}  // namespace

EffectKind effect_mesh() {
  return effect_kind<RigidPressOf<mesh_body>>("mesh", 35,
                                              en::say("A body is pressed into the face"),
                                              "file: nut_m6.stl, s_mm: 50, y_mm: 0, depth_mm: 0.8");
}

}  // namespace alltact
