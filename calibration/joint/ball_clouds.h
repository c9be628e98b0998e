// From balls that were found one by one to a mapping: one polynomial through all their depths.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"
#include "core/geometry/circle_fit.h"

#include <vector>

namespace alltact {

/// A ball, and what the face reads where it presses.
struct BallCloud {
  BallFit ball;
  std::vector<double> x, depth_mm;
};

/// The samples of a press, blocks of 2 px, that a circle in the picture holds.
[[nodiscard]] std::vector<Sample> samples_inside(const Press& press,
                                                 const Face& face,
                                                 const Circle& circle);

/// Depth of a ball over samples, where it presses at all: d = z_LUF - z_D, with the ball's point D
/// on the line along z on which the source paper's p_CF = p_LUF - (0, 0, d) lies. Error: the ball
/// presses fewer than 50 of them.
[[nodiscard]] Result<BallCloud> cloud_of_ball(const Press& press,
                                              const std::vector<Sample>& samples,
                                              const Eigen::Vector3d& centre_mm,
                                              bool cut_by_edge);

/// The cubic without constant through d of all clouds (at least one), written in the basis of
/// MappingParameters; one of lower degree where the cubic does not increase, said in a remark. Adds
/// mapping, balls and residuals to `calibration`. Error: no increasing curve.
[[nodiscard]] Result<Calibration> calibrate_through(const std::vector<BallCloud>& clouds,
                                                    Calibration calibration);

}  // namespace alltact
