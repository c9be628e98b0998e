// Numbers the markers of a recording from the dots found in every frame.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/finger/finger.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/recorded_poses.h"

#include <optional>
#include <vector>

namespace alltact {

/// Detections of one frame, in either polarity.
struct FrameDots {
  std::vector<Dot> bright, dark;
  EdgeCurves curves;  ///< of the face next to the dots
  Message problem;    ///< why there is nothing; empty when the frame was read and has a face
};

struct NumberedRecording {
  Polarity polarity = Polarity::kBright;
  std::vector<std::optional<Markers>> markers;  ///< by frame
  std::vector<Message> problems;                ///< by frame, where there are no markers
  std::vector<Dot> typical;
  std::vector<int> missing;  ///< numbers that no dot has, ascending
  std::optional<EdgePositions>
      positions;  ///< the markers are these positions on the face, not dots
  /// with positions: why there are no markers, empty: none requested
  Message no_markers;
  double marker_noise_px = 0;  ///< typical distance of a marker from its estimate by the others
};

/// Follows the dots through the recording, finds the two rows among the persistent
/// ones, learns their joint motion, and numbers every frame with that model. Positions
/// on the edges of the face replace the markers where less than a third of them or fewer than 4 are
/// found, or rows.per_row is 0. Error: fewer than 2 frames show the face.
[[nodiscard]] Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                                         const MarkerRows& rows);

// Tracks of dots through a recording, and the dots' positions on the finger.

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

// Selects the two rows of markers among the dots on the finger, and numbers them.

struct NumberedRows {
  std::vector<int> track_of;  ///< by number, an index into the tracks; -1: there is none
  double worth = 0;           ///< score of the choice: compares one polarity with the other
};

/// The dots that best follow a law. The step along the finger changes by about a constant factor
/// from one dot to the next (1 for even spacing in millimetres, more for even spacing in the
/// image). Size, contrast and distance from the face change little. At most two consecutive dots
/// may be missing; outliers are left out; both rows follow nearly the same law. A row shorter than
/// `per_row` takes the numbers of the adjacent dots in the other row, or begins at the base where
/// these do not decide. By dynamic programming over pairs of neighbours.
[[nodiscard]] NumberedRows choose_rows(const std::vector<DotTrack>& tracks, int per_row);

}  // namespace alltact
