// Numbers the markers of a recording from the dots found in every frame.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/edge_positions.h"

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

/// Follows the dots through the recording (dot_tracks.h), finds the two rows among the persistent
/// ones (row_law.h), learns their joint motion, and numbers every frame with that model. Positions
/// on the edges of the face replace the markers where less than a third of them or fewer than 4 are
/// found, or rows.per_row is 0. Error: fewer than 2 frames show the face.
[[nodiscard]] Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                                         const MarkerRows& rows);

}  // namespace alltact
