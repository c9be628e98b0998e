// From the dots found in every frame of a recording to numbered markers.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/pose_places.h"

#include <optional>
#include <vector>

namespace alltact {

/// What was found in one frame, in either polarity.
struct FrameDots {
  std::vector<Dot> bright, dark;
  EdgeCurves curves;  ///< of the face the dots lie beside
  Message problem;    ///< why there is nothing; empty when the frame was read and has a face
};

struct NumberedRecording {
  Polarity polarity = Polarity::kBright;
  std::vector<std::optional<Markers>> markers;  ///< by frame
  std::vector<Message> problems;                ///< by frame, where there are no markers
  std::vector<Dot> typical;
  std::vector<int> missing;          ///< numbers that no dot has, ascending
  std::optional<PosePlaces> places;  ///< the markers are these places of the face, not dots
  Message no_markers;                ///< with places: why there are no markers, empty: none wanted
  double marker_noise_px = 0;  ///< how far a marker typically lies from what the others tell of it
};

/// Follows the dots through the recording (dot_tracks.h), finds the two rows among those that are
/// there again and again (row_law.h), learns how they move together, and then numbers every frame
/// by that. Where less than a third of the markers or fewer than 4 can be found, or rows.per_row is
/// 0, places on the edges of the face stand in for them. Error: fewer than 2 frames show the face.
[[nodiscard]] Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                                         const MarkerRows& rows);

}  // namespace alltact
