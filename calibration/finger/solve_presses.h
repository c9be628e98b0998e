// The second part of a calibration: from measured presses to a mapping and its quality.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/sensing/reference/reference_library.h"

#include <functional>
#include <optional>
#include <vector>

namespace alltact {

using MeasureAsPaper = std::function<Result<std::vector<Press>>()>;

/// Calibrates with the presses of `done` that are not left out, and fills its residuals, zones,
/// signs of a fault, verdict and remarks. `references`: of each press. `as_paper`: the same presses
/// measured by the source paper's method; called only for a comparison of methods. `on_round`: see
/// calibrate(). Errors: no usable press; those of calibrate(); a method that does not support the
/// notes on the presses.
[[nodiscard]] Status solve_presses(FingerCalibration& done,
                                   const std::vector<std::optional<Reference>>& references,
                                   const MeasureAsPaper& as_paper,
                                   const Job& job,
                                   const RoundListener& on_round);

/// The record of a calibration in finger.yaml, next to its mapping.
[[nodiscard]] MappingRecord record_of(const FingerCalibration& done);

}  // namespace alltact
