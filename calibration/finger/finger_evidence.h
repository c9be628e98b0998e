// The evidence for a finger's verdict, from its folder as it is now.
#pragma once

#include "calibration/verdict/verdict.h"
#include "core/finger/finger_store.h"

#include <string>

namespace alltact {

/// Checks that the files of a finger's reference exist, are complete, and have its camera's image
/// size. Decodes one frame at most, and nothing while the files are unchanged; writes nothing.
[[nodiscard]] ReferenceState reference_state(const FingerSnapshot& snapshot);

/// evidence_of() plus the folder's evidence: the reference's files, the calibration's age, and the
/// command of a repetition.
///   now: UTC, as utc_now() writes it; empty: ages are unknown
///   passed: time of the last passed check of this calibration, likewise; empty: none
[[nodiscard]] CalibrationEvidence evidence_in(const FingerSnapshot& snapshot,
                                              const std::string& now,
                                              const std::string& passed = {});

/// Days between two such times; nullopt where one is invalid.
[[nodiscard]] std::optional<double> days_between(const std::string& then, const std::string& now);

}  // namespace alltact
