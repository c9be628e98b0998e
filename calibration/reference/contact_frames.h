// Excludes frames with a contact on the contact face from a recording, by its own frames and those
// of an earlier reference.
#pragma once

#include "calibration/reference/earlier_reference.h"
#include "calibration/reference/recorded_frames.h"
#include "calibration/reference/reference_recording.h"

#include <optional>
#include <vector>

namespace alltact {

/// Reduces `selected` (numbers in the recording) to frames that show a face and have no certain or
/// doubtful contact, or are chosen explicitly. Fills the report's stretches and counts. Frames are
/// compared with others of near pose in the recording; the earlier reference reveals a persistent
/// contact (lasting_touch.h). Errors: stopped; a contact at one position in most frames.
[[nodiscard]] Status exclude_contacts(RecordedVideo& video,
                                      const NumberedRecording& numbered,
                                      std::optional<EarlierReference>& earlier,
                                      const ReferenceChoices& choices,
                                      const Job& job,
                                      std::vector<std::size_t>& selected,
                                      ReferenceReport& report);

}  // namespace alltact
