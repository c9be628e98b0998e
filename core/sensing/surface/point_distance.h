// Distance between two points of the contact face, with its standard deviation.
#pragma once

#include "core/sensing/pipeline.h"
#include "core/sensing/surface/surface_patch.h"

#include <opencv2/core.hpp>

namespace alltact {

/// Straight distance between the contact face's points at two pixels.
///
/// A point p errs along its line of sight r (r_z = 1) by the face's z, sd s (FaceColumn::z_sd_mm),
/// and along z by its depth, sd d. With the unit vector e from one to the other
///   var = (e.r1 s1)^2 + (e.r2 s2)^2 - 2 rho (e.r1 s1)(e.r2 s2) + e_z^2 (d1^2 + d2^2).
/// The face's z is a smooth curve along it, fitted to all columns, so that errors of neighbours are
/// correlated:
///   rho = exp(-(u2 - u1)^2 / (2 (w / 8)^2)),
/// w the width of the face in columns and 8 the number of coefficients of the default curve. Errors
/// of the lens model and of the face's width are not included.
///
/// `sd_mm`: of the depth, as depth_sd_mm() returns it. Errors: a position is off the face; both
/// positions are the same.
[[nodiscard]] Result<MeasuredValue> straight_distance(const FrameResult& result,
                                                      const Face& face,
                                                      const cv::Mat& sd_mm,
                                                      cv::Point2d from,
                                                      cv::Point2d to);

}  // namespace alltact
