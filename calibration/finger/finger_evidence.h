// The evidence for a finger's verdict, from its folder as it is now.
#pragma once

#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <string>

namespace alltact {

/// Whether the files of a finger's reference are there, whole, and of its camera's image size.
/// Decodes one frame at most, and nothing while the files stay as they are; writes nothing.
[[nodiscard]] ReferenceState reference_state(const FingerSnapshot& snapshot);

/// evidence_of() with what the folder adds: the reference's files, the calibration's age, and how
/// to calibrate again.
///   now: UTC, as utc_now() writes it; empty: ages are unknown
///   passed: when the last check of this calibration passed, likewise; empty: none did
[[nodiscard]] CalibrationEvidence evidence_in(const FingerSnapshot& snapshot,
                                              const std::string& now,
                                              const std::string& passed = {});

/// Days from one such time to another; nullopt where one is none.
[[nodiscard]] std::optional<double> days_between(const std::string& then, const std::string& now);

}  // namespace alltact
