// The ball of one press by the shape of its contact, and what a mapping reads there beside it.
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
  /// Mapping minus ball, mm, of the samples in the inner part of the contact (kSureRim); never
  /// empty.
  std::vector<double> errors_mm;
};

/// Centre and one factor on all depths are fitted, so that a ball cannot sink in to meet a mapping
/// that reads too deep. The errors are those of the mapping without that factor. Errors: those of
/// find_ball(); a contact of too few pixels; no ball fits; stopped.
[[nodiscard]] Result<BallByShape> ball_by_shape(const Press& press,
                                                const Face& face,
                                                const Mapping& mapping,
                                                const Job& job);

/// What the mapping reads; below zero it goes on straight.
[[nodiscard]] double reading_mm(const Mapping& mapping, double x);

}  // namespace alltact
