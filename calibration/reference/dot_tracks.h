// Dots followed through a recording: which of them are there again and again, and where on the
// finger.
#pragma once

#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/pose_places.h"

#include <vector>

namespace alltact {

/// The dots of one frame and the face they lie beside.
struct FrameOfDots {
  const std::vector<Dot>* dots;
  const EdgeCurves* curves;
};

/// One dot of the finger, or what looked like one in several frames.
struct DotTrack {
  bool upper = false;
  double along_mm = 0;      ///< median over the frames, from a column that is the same in all
  double off_face = 0;      ///< medians, too
  double log_size = 0;      ///< of the radius in parts of the face's width in the picture
  double log_contrast = 0;  ///< of its magnitude
  double support = 0;       ///< part of the frames in which it was found
  std::vector<int> dot_of;  ///< by frame, an index into its dots; -1: not found
};

/// Links the frames in a tree, each to the one before it whose face is most alike in the picture,
/// so that neither the recording's order nor its speed matters, and follows the dots along the
/// branches. A dot that is not found is carried on as its neighbours move. Tracks found in less
/// than `least_support` of the frames are left out; the others are ordered from base to tip.
[[nodiscard]] std::vector<DotTrack> track_dots(const std::vector<FrameOfDots>& frames,
                                               double least_support);

}  // namespace alltact
