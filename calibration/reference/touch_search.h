// Where and when something pressed on the face while a reference was recorded.
//
// Untouched skin has a brightness that changes smoothly with the finger's pose, and what presses
// only darkens it (but for a faint bright rim). So the brightness of every patch of skin is fitted
// as a low-order function of the pose by a one-sided robust regression that starts from the bright
// side; what most varies with time over the whole face (lamps, gain) is taken out frame by frame.
// A touch is a compact group of patches that is darker than that, for a stretch of time.
//
// No frame is witness and accused at once: a frame is compared with a fit from which it and its
// neighbours in time are deleted, and the strongest touches leave the fit before weaker ones are
// searched.
#pragma once

#include "calibration/reference/skin_patches.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// What the search says of a frame.
enum class FrameTouch {
  kClean = 1,
  kUncompared,  ///< no frame of near pose at another time: a touch would not show
  /// Darker than the brightest, as something that presses is; but frames of near pose are as well,
  /// and such frames are more than a tenth: nobody can tell whether they show untouched skin.
  kUnexplained,
  kDoubtful,  ///< something is nearly as much darker as a touch is
  kTouched,
};

struct FrameEvidence {
  FrameTouch touch = FrameTouch::kUncompared;
  double darker = 0;     ///< of the most suspicious window, 0.1: by 10 %
  double strength = 0;   ///< of that window: from 1 on it alone shows a touch
  double along_mm = 0;   ///< its middle, from the base
  double across_mm = 0;  ///< from the middle line
  double motion_sd = 0;  ///< how far the markers lie off the finger's modes, in standard deviations
};

/// Frames that follow each other and are of one kind, but clean.
struct TouchStretch {
  std::size_t first = 0, last = 0;  ///< rows of the patches
  FrameTouch touch = FrameTouch::kTouched;
  std::size_t darkest = 0;  ///< the row with the strongest evidence
};

/// Of frames in order, those that are not clean.
[[nodiscard]] std::vector<TouchStretch> stretches_of(const std::vector<FrameEvidence>& frames);

/// By row of the patches. Fewer than kLeastFittedFrames are not compared. Motion is a witness that
/// makes darkening count more, and accuses no frame alone: a finger bent by hand moves in many
/// ways. modes: a row a frame, px, the most varied first. motion_off_px: by frame, root mean square
/// distance of its markers to the modes; may be empty. numbers: of the frames in the recording,
/// ascending.
[[nodiscard]] std::vector<FrameEvidence> find_touches(const SkinPatches& patches,
                                                      const Eigen::MatrixXd& modes,
                                                      const Eigen::VectorXd& motion_off_px,
                                                      const std::vector<int>& numbers);

}  // namespace alltact
