// A contact at one position in most frames of a recording. These frames agree with each other, but
// not with an earlier recording of the same skin.
#pragma once

#include "calibration/reference/skin_patches.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

struct PersistentContact {
  int frames = 0;     ///< in which it is visible
  int darkest = 0;    ///< row of the frame in which it is darkest
  double darker = 0;  ///< than the skin around it, median of the frames, 0.1: by 10 %
  double along_mm = 0, across_mm = 0;
};

/// The first `recorded` rows are the recording, the rows after them the earlier one. Each patch's
/// brightness in the earlier rows is fitted as a function of the pose. The median residual of the
/// recording's frames by patch shows what most of them share. Only a compact spot is a contact:
/// changed light makes wide differences. nullopt: there is none, or too few frames show poses of
/// the earlier recording.
[[nodiscard]] std::optional<PersistentContact> find_persistent_contact(const SkinPatches& patches,
                                                                       const Eigen::MatrixXd& modes,
                                                                       int recorded);

}  // namespace alltact
