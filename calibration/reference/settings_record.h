// What a finger's recordings were taken with, in its provenance, and what does not fit together.
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
/// removes what is there when the pictures told none. Returns a sentence where settings changed on
/// the way, and where reference and presses differ: brightness is compared between them.
[[nodiscard]] std::vector<Message> record_settings(const SettingsSeen& seen,
                                                   RecordingKind kind,
                                                   Finger& finger);

/// A sentence where a frame's settings are not those of the presses that the finger was calibrated
/// with (of its reference where these told none); else empty.
[[nodiscard]] Message other_settings_than_stored(const Frame& frame, const Finger& finger);

}  // namespace alltact
