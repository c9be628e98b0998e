// Signed distance of points from a closed triangle mesh.
#pragma once

#include "core/base/result.h"
#include "core/mesh/mesh_file.h"

#include <memory>

#include <Eigen/Core>

namespace alltact {

/// Finds the nearest point of a closed mesh. The sign comes from the angle-weighted normal of the
/// nearest face, edge or corner, which is right for every closed mesh (J. A. Baerentzen and H.
/// Aanaes, Signed distance computation using the angle weighted pseudonormal, IEEE TVCG 11(3),
/// 2005). Thread-safe.
class MeshDistance {
 public:
  /// Error, with an empty `where`: the mesh is not closed, or encloses nothing. Triangles that face
  /// inwards altogether are turned round.
  static Result<MeshDistance> create(const TriangleMesh& mesh);
  ~MeshDistance();
  MeshDistance(MeshDistance&&) noexcept;
  MeshDistance& operator=(MeshDistance&&) noexcept;

  struct Nearest {
    Eigen::Vector3d point;
    Eigen::Vector3d outwards;  ///< unit vector; the gradient of the distance
    double distance = 0;       ///< in the mesh's unit; negative inside
  };
  [[nodiscard]] Nearest operator()(const Eigen::Vector3d& point) const;

  [[nodiscard]] const TriangleMesh& mesh() const;

 private:
  struct Parts;
  struct NearestTriangle;
  explicit MeshDistance(std::unique_ptr<const Parts> parts);
  std::unique_ptr<const Parts> parts_;
};

}  // namespace alltact
