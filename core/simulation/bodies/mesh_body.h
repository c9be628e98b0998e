// A body given by triangles.
#pragma once

#include "core/io/mesh_file.h"
#include "core/simulation/bodies/body.h"

namespace alltact {

/// The mesh in mm, moved so that the middle of its box lies over the origin and its lowest points
/// at z = 0. Its faces are flat: a curved surface is met as the mesh has it.
class MeshBody final : public Body {
 public:
  /// `mesh` is closed. `scale`: mm of a unit of the file.
  MeshBody(TriangleMesh mesh, double scale);

  [[nodiscard]] std::unique_ptr<const PosedBody> posed(
      const Eigen::Isometry3d& camera_from_object) const override;
  [[nodiscard]] double least_along_mm(const Eigen::Vector3d& direction) const override;
  [[nodiscard]] Eigen::Vector2d half_size_mm() const override { return half_size_mm_; }
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

 private:
  TriangleMesh mesh_;
  Eigen::Vector2d half_size_mm_;
};

}  // namespace alltact
