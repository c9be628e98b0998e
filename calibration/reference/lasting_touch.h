// Something that pressed at one place in most frames of a recording: they agree with each other,
// but not with an earlier recording of the same skin.
#pragma once

#include "calibration/reference/skin_patches.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

struct LastingTouch {
  int frames = 0;     ///< in which it is seen
  int darkest = 0;    ///< row of the frame in which it is most so
  double darker = 0;  ///< than the skin around it, median of the frames, 0.1: by 10 %
  double along_mm = 0, across_mm = 0;
};

/// The first `recorded` rows are the recording, those behind them are the earlier one, to which
/// each patch's brightness is fitted as a function of the pose. What is left of the recording's
/// frames, their median by patch, shows what most of them share. Only a compact spot is a touch:
/// light that has changed since makes wide differences. nullopt: there is none, or too few frames
/// show poses of the earlier recording.
[[nodiscard]] std::optional<LastingTouch> find_lasting_touch(const SkinPatches& patches,
                                                             const Eigen::MatrixXd& modes,
                                                             int recorded);

}  // namespace alltact
