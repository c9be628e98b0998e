// Ground truth of what presses on the finger in one frame, and how hard.
#pragma once

#include "core/finger/pushed_face.h"

#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace alltact {

/// Camera frame, mm, N. `along` and `across` are positions on the finger: along it from the face's
/// base, and across from its middle line.
struct ContactTruth {
  std::string name;  ///< of the effect: "ball#2"
  PushedFace face = PushedFace::kContact;
  double along_mm = 0, across_mm = 0;
  double depth_mm = 0;  ///< maximum press depth along z; 0: the layer is not indented
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< of the undeformed outer side there
  /// Unit vector into the finger: the direction of the push.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /// Rotation of a body with a direction: from the finger's length towards +y, about the normal.
  std::optional<double> angle_deg;
  std::optional<Eigen::Vector3d> force_N;  ///< on the finger; empty where the scene gives no force
  std::optional<Eigen::Isometry3d> camera_from_object;
};

}  // namespace alltact
