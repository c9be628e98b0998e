// Which lamps light a finger as it is lit.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/job.h"
#include "core/result.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// An untouched picture.
struct TwinUntouched {
  TwinPose pose;
  cv::Mat grey;  ///< CV_32FC1; NaN where it tells nothing
};

/// Standard deviations of one lamp's numbers; absent: the pictures do not tell them.
struct LampSpread {
  std::optional<Eigen::Vector3d> at_mm;
  std::optional<double> power;
};

struct TwinLamps {
  std::vector<TwinLamp> lamps;
  double room_level = 0;
  std::vector<LampSpread> spread;  ///< one a lamp
  double rms = 0;                  ///< of block means, grey levels
};

inline constexpr std::size_t kMostLamps = 8;

/// Of a scene whose camera, face and layer stand. Lamps are added one by one, from a grid about the
/// face and aimed along it, as long as they make the residual smaller by a thirtieth, and moved
/// together. Errors: nothing to compare, the scene cannot be rendered, stopped.
[[nodiscard]] Result<TwinLamps> fit_lamps(const TwinScene& scene,
                                          const std::vector<TwinUntouched>& untouched,
                                          const Job& job);

}  // namespace alltact
