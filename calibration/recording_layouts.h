// From the dots found in every frame of a recording to numbered markers.
#pragma once

#include "core/finger/finger.h"
#include "core/result.h"
#include "core/sensing/markers.h"

#include <string>
#include <vector>

namespace alltact {

/// What was found in one frame, in either polarity.
struct FrameDots {
  std::vector<Dot> bright, dark;
  bool base_at_low_u = true;
  std::string problem;  ///< why there is nothing; empty when the frame was read and has a face
};

struct NumberedRecording {
  Polarity polarity = Polarity::kBright;
  std::vector<std::optional<Markers>> markers;  ///< by frame
  std::vector<std::string> problems;            ///< by frame, where there are no markers
  std::vector<Dot> typical;
  double marker_noise_px = 0;  ///< how far a marker typically lies from what the others tell of it
};

/// Numbers first the frames whose two rows are plain (exactly per_row even dots on each side),
/// learns how they move together, and then numbers every frame by that. Error: fewer than 2 such
/// frames; says how many dots were found on each side.
[[nodiscard]] Result<NumberedRecording> number_recording(const std::vector<FrameDots>& frames,
                                                         const MarkerRows& rows);

}  // namespace alltact
