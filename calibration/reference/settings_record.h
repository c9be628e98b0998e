// Settings of a finger's recordings, in its provenance, and their inconsistencies.
#pragma once

#include "core/finger/finger.h"
#include "core/message.h"
#include "core/sources/frame_settings.h"

#include <vector>

namespace alltact {

/// Keys of Finger::provenance.
inline constexpr const char* kReferenceSettings = "reference_settings";
inline constexpr const char* kPressSettings = "press_settings";

enum class RecordingKind { kReference = 1, kPresses };

/// Writes the settings of camera and light to provenance (reference_settings or press_settings), or
/// removes them when the images have none. Returns a sentence where settings changed during the
/// recording, and where reference and presses differ: brightness is compared between them.
[[nodiscard]] std::vector<Message> record_settings(const SettingsMonitor& seen,
                                                   RecordingKind kind,
                                                   Finger& finger);

/// A sentence where a frame's settings differ from those of the finger's calibration presses (of
/// its reference where the presses have none); else empty.
[[nodiscard]] Message other_settings_than_stored(const Frame& frame, const Finger& finger);

}  // namespace alltact
