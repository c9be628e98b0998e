// Whether a layer spreads light, and a calibration that takes it into account.
//
// A local mapping reads the skirt of scattered light (light_spread.h) as depth next to a contact,
// and calibration with balls hides it inside. Here the brightness around every ball, up to several
// layer thicknesses beyond its rim, is explained at once: by the ball, the skin that leaves it
// (skin_profile.h), the spread of light, and on a finger that bends an error of each press's light
// (spread_model.h).
//
// CHOICE
// Local light, with the thickness that counts along the normal, along z or along the line of sight,
// explains the same pixels with a skin of any form. Spread light is taken where it is more
// probable, with all that either of both may be: local fingers are explained by skirts narrower
// than layers have. Neighbouring pixels count as one over the area of three squares of the layer's
// thickness, since what the formulas leave varies as slowly.
#pragma once

#include "calibration/joint/joint_fit.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/finger/finger.h"
#include "core/finger/mapping.h"

#include <functional>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct BallStart {
  const Press* press = nullptr;
  Eigen::Vector3d centre_mm;
};

/// Scale of depth that a mapping has by a body of known shape: depth read / true depth.
struct ScaleSeen {
  double scale = 1;
  double sd = 0;  ///< of the scale, by the body's press alone
};
/// The scales by all bodies for a mapping without x_max, in the same order at every call.
using ReadScales = std::function<std::vector<ScaleSeen>(const MappingParameters&)>;

/// The same by balls alone; `sd` of both.
struct ScaleByBalls {
  double scale = 1, sd = 0;
  bool agrees = true;  ///< within four standard deviations; others are not used
};

/// Only `is_seen` and `log_evidence` are set where it is not seen.
struct LightSpreadFit {
  MappingParameters mapping;                ///< without x_max
  std::vector<Eigen::Vector3d> centres_mm;  ///< in order of the presses
  Eigen::MatrixXd centre_covariance;        ///< 3 x 3 for each press, below each other
  double lift_mm = 0;
  /// How much each ball's depth changes when the other presses alone give the mapping.
  std::vector<double> held_out_mm;
  std::vector<ScaleByBalls> scales;  ///< in the order of ReadScales
  /// log of the probability over that of the best local light, or of the first that explains enough
  double log_evidence = 0;
  bool is_seen = false;  ///< significant, in most presses
};

/// nullopt: fewer than three presses, or no fit. Two to four seconds of single fits at most.
/// `read_scales` is called only where the spread is seen; may be empty. Bodies decide nothing about
/// that.
[[nodiscard]] std::optional<LightSpreadFit> fit_light_spread(const std::vector<BallStart>& balls,
                                                             const Face& face,
                                                             const ReadScales& read_scales,
                                                             const Job& job);

/// The press as a layer with local light would show it.
[[nodiscard]] Press without_light_spread(const Press& press, const MappingParameters& mapping);

}  // namespace alltact
