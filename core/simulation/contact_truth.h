// What presses on the finger in one frame, and how hard.
#pragma once

#include "core/finger/pushed_face.h"

#include <optional>
#include <string>

#include <Eigen/Geometry>

namespace alltact {

/// Camera frame, mm, N. `along` and `across` are places on the finger: from the face's base along
/// it, and from its middle line.
struct ContactTruth {
  std::string name;  ///< of the effect: "ball#2"
  PushedFace face = PushedFace::kContact;
  double along_mm = 0, across_mm = 0;
  double depth_mm = 0;  ///< greatest press depth along z; 0: the layer is not pressed in
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();  ///< of the untouched outer side there
  /// Unit, into the finger: the way in which it is pushed.
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();
  /// Of a body that has a direction: from the finger's length towards +y, about the normal.
  std::optional<double> angle_deg;
  std::optional<Eigen::Vector3d> force_N;  ///< on the finger, where the scene tells
  std::optional<Eigen::Isometry3d> camera_from_object;
};

}  // namespace alltact
