// Estimates the ball of one press from the shape of its contact, and the mapping's errors there.
#pragma once

#include "calibration/presses/press.h"
#include "core/finger/mapping.h"
#include "core/job.h"
#include "core/result.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

struct BallByShape {
  Eigen::Vector3d centre_mm;                             ///< camera frame
  double factor = 1;                                     ///< true depth / depth read
  double depth_mm = 0;                                   ///< of its deepest point
  Eigen::Vector2d on_face_mm = Eigen::Vector2d::Zero();  ///< of its contact, along and across
  /// Mapping minus ball, mm, of the samples in the inner zone of the contact (kInnerRim); never
  /// empty.
  std::vector<double> errors_mm;
};

/// Fits the centre and one factor on all depths, so that the ball cannot sink in to meet a mapping
/// that is too deep. The errors are those of the mapping without that factor. Errors: those of
/// find_ball(); a contact of too few pixels; no ball fits; stopped.
[[nodiscard]] Result<BallByShape> ball_by_shape(const Press& press,
                                                const Face& face,
                                                const Mapping& mapping,
                                                const Job& job);

/// The depth by the mapping; below zero it continues as a straight line.
[[nodiscard]] double reading_mm(const Mapping& mapping, double x);

}  // namespace alltact
