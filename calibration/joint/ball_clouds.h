// From balls that were found one by one to a mapping: one polynomial through all their depths.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"
#include "core/geometry/circle_fit.h"
#include "core/job.h"
#include "core/message.h"
#include "core/result.h"

#include <utility>
#include <vector>

namespace alltact {

/// A ball, and the brightness differences and depths of its samples.
struct BallCloud {
  BallFit ball;
  std::vector<double> x, depth_mm;
};

/// The samples of a press, blocks of 2 px, within a circle in the image.
[[nodiscard]] std::vector<Sample> samples_inside(const Press& press,
                                                 const Face& face,
                                                 const Circle& circle);

/// Computes the depth of a ball over samples, where it presses at all: d = z_LUF - z_D. The ball's
/// point D lies on the line along z of the source paper's p_CF = p_LUF - (0, 0, d). Error: the ball
/// presses fewer than 50 samples.
[[nodiscard]] Result<BallCloud> cloud_of_ball(const Press& press,
                                              const std::vector<Sample>& samples,
                                              const Eigen::Vector3d& centre_mm,
                                              bool cut_by_edge);

/// The clouds of the presses for which `cloud_of` finds one. `left_out` holds the reasons of the
/// others.
struct CloudsFound {
  std::vector<BallCloud> clouds;
  std::vector<Message> left_out;
  Message reason;        ///< of the last press left out
  bool stopped = false;  ///< some presses were not processed
};
template <class Presses, class CloudOf>
[[nodiscard]] CloudsFound clouds_of(const Presses& presses, CloudOf&& cloud_of, const Job& job) {
  CloudsFound found;
  for (const auto& press : presses) {
    if (job.stop_requested()) {
      found.stopped = true;
      break;
    }
    Result<BallCloud> cloud = cloud_of(press);
    if (cloud) {
      found.clouds.push_back(std::move(*cloud));
    } else {
      found.left_out.push_back(en::say("{}.", cloud.error().message()));
      found.reason = cloud.error().what;
    }
  }
  return found;
}

/// Fits the cubic without constant through d of all clouds (at least one), in the basis of
/// MappingParameters. Where the cubic does not increase, a lower degree is used and a remark states
/// it. Adds mapping, balls and residuals to `calibration`. Error: no increasing curve.
[[nodiscard]] Result<Calibration> fit_cubic_mapping(const std::vector<BallCloud>& clouds,
                                                    Calibration calibration);

}  // namespace alltact
