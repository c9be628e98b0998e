// Tracks of dots through a recording, and the dots' positions on the finger.
#pragma once

#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/edge_positions.h"

#include <vector>

namespace alltact {

/// The dots of one frame and the face next to them.
struct FrameOfDots {
  const std::vector<Dot>* dots;
  const EdgeCurves* curves;
};

/// One dot of the finger, or an artefact in several frames.
struct DotTrack {
  bool upper = false;
  double along_mm = 0;      ///< median over the frames, from a column that is the same in all
  double off_face = 0;      ///< medians, too
  double log_size = 0;      ///< of the radius as a fraction of the face's width in the image
  double log_contrast = 0;  ///< of its magnitude
  double support = 0;       ///< fraction of the frames in which it was found
  std::vector<int> dot_of;  ///< by frame, an index into its dots; -1: not found
};

/// Links the frames in a tree, each to the earlier frame with the most similar face in the image,
/// and follows the dots along the branches. Order and speed of the recording do not matter. A dot
/// that is not found moves with its neighbours. Tracks found in less than `min_support` of the
/// frames are dropped; the others are ordered from base to tip.
[[nodiscard]] std::vector<DotTrack> track_dots(const std::vector<FrameOfDots>& frames,
                                               double min_support);

}  // namespace alltact
