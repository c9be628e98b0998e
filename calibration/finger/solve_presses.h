// The second part of a calibration: from measured presses to a mapping and what it is worth.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/sensing/reference/reference_library.h"

#include <functional>
#include <optional>
#include <vector>

namespace alltact {

using MeasureAsPaper = std::function<Result<std::vector<Press>>()>;

/// Calibrates with the presses of `done` that are not left out, and tells of the result: residuals,
/// zones, signs of a fault, verdict and remarks. `references`: what each press was compared with.
/// `as_paper`: where other methods are to be compared with, the same presses as the source paper's
/// method measures them; asked for only then. `on_round`: see calibrate(). Errors: no usable press,
/// those of calibrate(), a method that cannot use what was said of the presses.
[[nodiscard]] Status solve_presses(FingerCalibration& done,
                                   const std::vector<std::optional<Reference>>& references,
                                   const MeasureAsPaper& as_paper,
                                   const Job& job,
                                   const RoundListener& on_round);

/// What finger.yaml stores of a calibration beside its mapping.
[[nodiscard]] MappingRecord record_of(const FingerCalibration& done);

}  // namespace alltact
