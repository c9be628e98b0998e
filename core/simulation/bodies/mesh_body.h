// A body given by triangles.
#pragma once

#include "core/io/mesh_file.h"
#include "core/simulation/bodies/body.h"

namespace alltact {

/// The mesh in mm. Its bounding box is centred over the origin and its lowest points lie at z = 0.
/// Its facets are flat: a curved surface is only as smooth as the mesh.
class MeshBody final : public Body {
 public:
  /// `mesh` is closed. `scale`: mm per unit of the file.
  MeshBody(TriangleMesh mesh, double scale);

  [[nodiscard]] std::unique_ptr<const PosedBody> posed(
      const Eigen::Isometry3d& camera_from_object) const override;
  [[nodiscard]] double min_along_mm(const Eigen::Vector3d& direction) const override;
  [[nodiscard]] Eigen::Vector2d half_size_mm() const override { return half_size_mm_; }
  [[nodiscard]] const TriangleMesh& mesh() const { return mesh_; }

 private:
  TriangleMesh mesh_;
  Eigen::Vector2d half_size_mm_;
};

}  // namespace alltact
