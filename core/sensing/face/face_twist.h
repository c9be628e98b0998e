// Twist: rotation of a face's cross-sections about the finger's length, from base to tip.
#pragma once

#include <Eigen/Core>

namespace alltact {

/// Tangent of the twist over the face's length, t from -1 to 1: c0 + c1 t + c2 (2 t^2 - 1).
/// Positive: the side at large v is turned away from the camera.
struct FaceTwist {
  static constexpr int kTerms = 3;

  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  /// Yaw of the cross-sections per slope dy/ds of a swaying middle line: 1 as in a beam, 0 where
  /// they slide past each other.
  double yaw_per_slope = 0;

  [[nodiscard]] static Eigen::RowVector3d terms_at(double t) { return {1.0, t, 2.0 * t * t - 1.0}; }
  [[nodiscard]] double at(double t) const { return terms_at(t) * coefficients; }
  [[nodiscard]] double variance_at(double t) const {
    return terms_at(t) * covariance * terms_at(t).transpose();
  }
};

}  // namespace alltact
