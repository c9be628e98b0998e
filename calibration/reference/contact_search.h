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

#include "calibration/reference/skin_brightness.h"
#include "core/base/message.h"
#include "core/sensing/depth/depth_map.h"

#include <optional>
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
  FrameContact contact = FrameContact::kUncompared;
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
  FrameContact contact = FrameContact::kContact;
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

// A contact at one position in most frames of a recording. These frames agree with each other, but
// not with an earlier recording of the same skin.

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

// A contradiction between a finger and its reference: skin brighter than ever untouched indicates a
// contact during the recording of the reference.

struct ReferenceSuspect {
  double brighter = 0;   ///< than the reference, 0.1: by 10 %
  double along_mm = 0;   ///< the middle of the spot, from the base
  double across_mm = 0;  ///< and from the middle line
  double area_mm2 = 0;
  int frame = 0;  ///< number in the reference recording of the frame nearest to the pose
};

/// The brightest spot of x. A bright rim around a contact does not count. For poses
/// inside the reference; the caller sets `frame`.
[[nodiscard]] std::optional<ReferenceSuspect> find_reference_suspect(const Difference& difference,
                                                                     const FaceShape& shape);

/// What happened, where, and what to do.
[[nodiscard]] Message sentence_of(const ReferenceSuspect& suspect);

}  // namespace alltact
