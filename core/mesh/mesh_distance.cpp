#include "core/mesh/mesh_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <unsupported/Eigen/BVH>

namespace alltact {
namespace {

using Box = Eigen::AlignedBox3d;
using Tree = Eigen::KdBVH<double, 3, int>;

/// The nearest point of a triangle by its barycentric coordinates; exact zeros show the edge or
/// corner that it lies on. C. Ericson, Real-Time Collision Detection, 5.1.5.
Eigen::Vector3d nearest_weights(const Eigen::Vector3d& point, const Eigen::Vector3d& a,
                                const Eigen::Vector3d& b, const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a;
  const double a_b = ab.dot(point - a), a_c = ac.dot(point - a);
  if (a_b <= 0 && a_c <= 0) return {1, 0, 0};
  const double b_b = ab.dot(point - b), b_c = ac.dot(point - b);
  if (b_b >= 0 && b_c <= b_b) return {0, 1, 0};
  const double on_c = a_b * b_c - b_b * a_c;
  if (on_c <= 0 && a_b >= 0 && b_b <= 0) {
    const double along = a_b / (a_b - b_b);
    return {1 - along, along, 0};
  }
  const double c_b = ab.dot(point - c), c_c = ac.dot(point - c);
  if (c_c >= 0 && c_b <= c_c) return {0, 0, 1};
  const double on_b = c_b * a_c - a_b * c_c;
  if (on_b <= 0 && a_c >= 0 && c_c <= 0) {
    const double along = a_c / (a_c - c_c);
    return {1 - along, 0, along};
  }
  const double on_a = b_b * c_c - c_b * b_c;
  if (on_a <= 0 && b_c - b_b >= 0 && c_b - c_c >= 0) {
    const double along = (b_c - b_b) / ((b_c - b_b) + (c_b - c_c));
    return {0, 1 - along, along};
  }
  const double sum = on_a + on_b + on_c;
  return {on_a / sum, on_b / sum, on_c / sum};
}

/// Six times the enclosed volume.
double volume6(const TriangleMesh& mesh) {
  double volume = 0;
  const Eigen::Vector3d origin = mesh.points.front();  // near the mesh: nothing large cancels
  for (const auto& [i, k, l] : mesh.triangles) {
    const auto at = [&](int n) -> Eigen::Vector3d {
      return mesh.points[static_cast<std::size_t>(n)] - origin;
    };
    volume += at(i).dot(at(k).cross(at(l)));
  }
  return volume;
}

}  // namespace

struct MeshDistance::Parts {
  TriangleMesh mesh;
  std::vector<Eigen::Vector3d> normals;                         // of triangles; 0 without area
  std::vector<Eigen::Vector3d> corner_normals;                  // of points, weighted by angle
  std::map<std::pair<int, int>, Eigen::Vector3d> edge_normals;  // smaller number first
  Tree tree;

  [[nodiscard]] const Eigen::Vector3d& at(int point) const {
    return mesh.points[static_cast<std::size_t>(point)];
  }
  void add_normals();
  void grow_tree();
};

void MeshDistance::Parts::add_normals() {
  corner_normals.assign(mesh.points.size(), Eigen::Vector3d::Zero());
  for (const auto& corners : mesh.triangles) {
    const Eigen::Vector3d area =
        (at(corners[1]) - at(corners[0])).cross(at(corners[2]) - at(corners[0]));
    const Eigen::Vector3d normal = area.stableNormalized();
    normals.push_back(normal.allFinite() ? normal : Eigen::Vector3d::Zero().eval());
    for (std::size_t k = 0; k < 3; ++k) {
      const int here = corners[k], next = corners[(k + 1) % 3], last = corners[(k + 2) % 3];
      const Eigen::Vector3d one = at(next) - at(here), other = at(last) - at(here);
      const double angle = std::atan2(one.cross(other).norm(), one.dot(other));
      corner_normals[static_cast<std::size_t>(here)] += angle * normals.back();
      edge_normals.try_emplace(std::minmax(here, next), Eigen::Vector3d::Zero()).first->second +=
          normals.back();
    }
  }
}

void MeshDistance::Parts::grow_tree() {
  std::vector<int> numbers;
  std::vector<Box> boxes;
  for (const auto& [a, b, c] : mesh.triangles) {
    Box box(at(a));
    box.extend(at(b)).extend(at(c));
    numbers.push_back(static_cast<int>(boxes.size()));
    boxes.push_back(box);
  }
  tree = Tree(numbers.begin(), numbers.end(), boxes.begin(), boxes.end());
}

/// As Eigen's tree asks: squared distances from boxes and triangles. Holds the nearest triangle.
struct MeshDistance::NearestTriangle {
  const Parts& parts;
  Eigen::Vector3d point;
  double best = std::numeric_limits<double>::infinity();
  int triangle = 0;
  Eigen::Vector3d at = Eigen::Vector3d::Zero(), weights = Eigen::Vector3d::Zero();

  using Scalar = double;
  [[nodiscard]] double minimumOnVolume(const Box& box) const {
    return box.squaredExteriorDistance(point);
  }
  double minimumOnObject(int number) {
    const auto& corners = parts.mesh.triangles[static_cast<std::size_t>(number)];
    const Eigen::Vector3d &a = parts.at(corners[0]), &b = parts.at(corners[1]),
                          &c = parts.at(corners[2]);
    const Eigen::Vector3d near = nearest_weights(point, a, b, c);
    const Eigen::Vector3d there = near[0] * a + near[1] * b + near[2] * c;
    const double squared = (point - there).squaredNorm();
    if (squared < best) best = squared, triangle = number, at = there, weights = near;
    return squared;
  }
};

MeshDistance::MeshDistance(std::unique_ptr<const Parts> parts) : parts_(std::move(parts)) {}
MeshDistance::~MeshDistance() = default;
MeshDistance::MeshDistance(MeshDistance&&) noexcept = default;
MeshDistance& MeshDistance::operator=(MeshDistance&&) noexcept = default;

Result<MeshDistance> MeshDistance::create(const TriangleMesh& mesh) {
  if (Status closed = check_closed(mesh); !closed) return closed.error();
  auto parts = std::make_unique<Parts>();
  parts->mesh = mesh;
  const double volume = volume6(mesh);
  if (!(std::abs(volume) > 0))
    return Error{en::say("the mesh encloses no volume"), "", en::say("a mesh of a solid body")};
  if (volume < 0)
    for (auto& corners : parts->mesh.triangles) std::swap(corners[1], corners[2]);
  parts->add_normals();
  parts->grow_tree();
  return MeshDistance(std::move(parts));
}

const TriangleMesh& MeshDistance::mesh() const { return parts_->mesh; }

MeshDistance::Nearest MeshDistance::operator()(const Eigen::Vector3d& point) const {
  const Parts& parts = *parts_;
  NearestTriangle search{parts, point};
  const double best = Eigen::BVMinimize(parts.tree, search);  // squared
  const auto& corners = parts.mesh.triangles[static_cast<std::size_t>(search.triangle)];
  const Eigen::Vector3d& weights = search.weights;
  Eigen::Vector3d normal = parts.normals[static_cast<std::size_t>(search.triangle)];
  const auto zeros = (weights.array() == 0).count();
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = weights[static_cast<Eigen::Index>(k)];
    if (zeros == 2 && weight != 0)
      normal = parts.corner_normals[static_cast<std::size_t>(corners[k])];
    if (zeros == 1 && weight == 0)
      normal = parts.edge_normals.at(std::minmax(corners[(k + 1) % 3], corners[(k + 2) % 3]));
  }
  Nearest nearest;
  nearest.point = search.at;
  nearest.outwards = normal.normalized();
  const Eigen::Vector3d off = point - nearest.point;
  const double sign = off.dot(nearest.outwards) < 0 ? -1 : 1;
  nearest.distance = sign * std::sqrt(best);
  // Away from the surface the direction to it is exact; on it the normal stands for it.
  if (best > 1e-18 * nearest.point.squaredNorm() && best > 0)
    nearest.outwards = sign * off / std::sqrt(best);
  return nearest;
}

}  // namespace alltact
