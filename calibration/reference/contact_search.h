// Contacts on the face during the recording of a reference: positions and frames.
//
// Untouched skin has a brightness that changes smoothly with the finger's pose, and a contact only
// darkens it (except for a faint bright rim). The brightness of every patch of skin is therefore
// fitted as a low-order function of the pose. The fit is a one-sided robust regression that starts
// from the bright side. Variations over the full face (lamps, gain) are removed frame by frame. A
// contact is a compact group of darker patches over consecutive frames.
//
// No frame tests itself: it is compared with a fit without it and its neighbours in time. The
// strongest contacts leave the fit before weaker ones are searched.
#pragma once

#include "calibration/reference/skin_patches.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Result of the search for a frame.
enum class FrameContact {
  kClean = 1,
  kUncompared,  ///< no frame of near pose at another time: a contact would be invisible
  /// Darker than the brightest, as with a contact; but frames of near pose are dark too, and such
  /// frames are more than a tenth: it is undecided whether they show untouched skin.
  kUnexplained,
  kDoubtful,  ///< nearly as dark as a contact
  kContact,
};

struct FrameEvidence {
  FrameContact touch = FrameContact::kUncompared;
  double darker = 0;     ///< of the most suspicious window, 0.1: by 10 %
  double strength = 0;   ///< of that window: from 1 on it alone proves a contact
  double along_mm = 0;   ///< its middle, from the base
  double across_mm = 0;  ///< from the middle line
  /// distance of the markers from the finger's modes, in standard deviations
  double motion_sd = 0;
};

/// Consecutive frames of one kind, except clean ones.
struct ContactStretch {
  std::size_t first = 0, last = 0;  ///< rows of the patches
  FrameContact touch = FrameContact::kContact;
  std::size_t darkest = 0;  ///< the row with the strongest evidence
};

/// frames: in order. Clean ones are omitted.
[[nodiscard]] std::vector<ContactStretch> stretches_of(const std::vector<FrameEvidence>& frames);

/// By row of the patches. Fewer than kMinFittedFrames frames are not compared. Irregular motion
/// adds weight to darkening and proves nothing alone: a finger bent by hand moves irregularly.
/// modes: a row a frame, px, the most varied first. motion_off_px: by frame, root mean square
/// distance of its markers to the modes; may be empty. numbers: of the frames in the recording,
/// ascending.
[[nodiscard]] std::vector<FrameEvidence> find_contacts(const SkinPatches& patches,
                                                       const Eigen::MatrixXd& modes,
                                                       const Eigen::VectorXd& motion_off_px,
                                                       const std::vector<int>& numbers);

}  // namespace alltact
