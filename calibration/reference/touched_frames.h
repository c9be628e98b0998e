// Takes frames out of a recording in which something pressed on the contact face, by what the
// recording's own frames and those of an earlier reference say.
#pragma once

#include "calibration/reference/earlier_reference.h"
#include "calibration/reference/recorded_frames.h"
#include "calibration/reference/reference_recording.h"

#include <optional>
#include <vector>

namespace alltact {

/// Leaves those of `kept` (numbers in the recording) that show a face and are neither touched nor
/// doubtful, or are chosen all the same, and fills the report's stretches and counts. Frames are
/// compared with others of near pose in the recording; those of the earlier reference tell of a
/// touch that lasts (lasting_touch.h).
/// Errors: stopped; something pressed at one place in most frames.
[[nodiscard]] Status leave_out_touched(RecordedVideo& video,
                                       const NumberedRecording& numbered,
                                       std::optional<EarlierReference>& earlier,
                                       const ReferenceChoices& choices,
                                       const Job& job,
                                       std::vector<std::size_t>& kept,
                                       ReferenceReport& report);

}  // namespace alltact
