// Lamps that reproduce the light of a finger.
#pragma once

#include "calibration/twin/twin_scene.h"
#include "core/job.h"
#include "core/result.h"

#include <optional>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// An untouched image.
struct TwinUntouched {
  TwinPose pose;
  cv::Mat grey;  ///< CV_32FC1; NaN where it has no information
};

/// Standard deviations of one lamp's numbers; empty: the images do not determine them.
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

inline constexpr std::size_t kMaxLamps = 8;

/// Needs a scene with final camera, face and layer. Lamps are added one by one from a grid about
/// the face, aimed along it, while each reduces the residual by a thirtieth, and are then moved
/// together. Errors: nothing to compare; the scene cannot be rendered; stopped.
[[nodiscard]] Result<TwinLamps> fit_lamps(const TwinScene& scene,
                                          const std::vector<TwinUntouched>& untouched,
                                          const Job& job);

}  // namespace alltact
