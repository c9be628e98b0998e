// The pose of a body of known shape from the skin that lies on it.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/mesh/mesh_distance.h"

#include <limits>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace alltact {

/// A line on which a point of the skin moves when it is pressed: base - depth * along.
struct SkinLine {
  Eigen::Vector3d base, along;
};

struct SkinPoint {
  SkinLine line;
  double depth_mm = 0;
  [[nodiscard]] Eigen::Vector3d at(double factor) const {
    return line.base - factor * depth_mm * line.along;
  }
};

/// Distance of a point in the camera frame from the posed body, with its gradient.
struct Gap {
  double mm = 0;
  Eigen::Vector3d outwards;
};
[[nodiscard]] Gap gap_at(const MeshDistance& shape, const Eigen::Isometry3d& camera_from_body,
                         const Eigen::Vector3d& point);

/// The surface of a body around a point, to second order.
struct BodyPatch {
  Eigen::Vector3d point, outwards;  ///< mm; unit vector
  Eigen::Matrix3d bend;             ///< derivative of `outwards` along the surface, 1/mm
};

/// What gaps of skin points are measured from: a mesh, or the patch of each point.
class BodySurface {
 public:
  explicit BodySurface(const MeshDistance& shape) : shape_(&shape) {}
  explicit BodySurface(const std::vector<BodyPatch>& patches) : patches_(&patches) {}
  [[nodiscard]] Gap gap(std::size_t i, const Eigen::Isometry3d& camera_from_body,
                        const Eigen::Vector3d& point) const;

 private:
  const MeshDistance* shape_ = nullptr;
  const std::vector<BodyPatch>* patches_ = nullptr;
};

/// Gaps at a pose, and how they change by motions of the body (turn about the centre, shift) and
/// by the factor on the depths.
struct BodyGaps {
  Eigen::MatrixXd by_pose;
  Eigen::VectorXd by_factor, mm;
  std::vector<Eigen::Vector3d> outwards;
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double reach_mm = 1;  ///< makes turns as large as shifts
};
[[nodiscard]] BodyGaps gaps_at(const std::vector<SkinPoint>& skin, const BodySurface& surface,
                               const Eigen::Isometry3d& camera_from_body, double factor);

/// Weights against points that do not rest on the body (Huber, 2 standard deviations).
[[nodiscard]] Eigen::VectorXd root_weights(const Eigen::VectorXd& gaps_mm);

/// What of the factor's effect no motion of the body imitates.
[[nodiscard]] Eigen::VectorXd of_factor_alone(const BodyGaps& gaps, const Eigen::VectorXd& roots);
constexpr double kNoStrength = 1e-12;  // mm^2: a factor on depths of 0 changes nothing

struct BodyPose {
  Eigen::Isometry3d camera_from_body = Eigen::Isometry3d::Identity();
  double factor = 1;  ///< true depth / depth read
  double rms_mm = std::numeric_limits<double>::infinity();
};

/// One step of robust least squares.
void refine_pose(const std::vector<SkinPoint>& skin, const BodySurface& surface, bool frees_factor,
                 BodyPose& posed);

/// Tries all orientations of the body: a few steps from each, more from the best. normal: of the
/// skin, away from the camera; frees_factor: the depths may be wrong by a common factor. Error:
/// stopped. skin: not empty.
[[nodiscard]] Result<BodyPose> find_pose(const std::vector<SkinPoint>& skin,
                                         const Eigen::Vector3d& normal, const MeshDistance& shape,
                                         bool frees_factor, const Job& job);

}  // namespace alltact
