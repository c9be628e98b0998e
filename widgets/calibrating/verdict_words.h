// Sentences about the rated accuracy of the calibration in use, and about the forecast with the
// present presses.
#pragma once

#include "widgets/calibrating/press_forecast.h"
#include "widgets/verdict_text.h"

#include <optional>

namespace alltact {

/// Verdict on the calibration in use, as of now. nullopt: there is none, or its evidence is not
/// stored.
[[nodiscard]] std::optional<Verdict> verdict_of(const CalibrationRun& run);

/// Why a calibration has to be repeated, as sentences; empty: it is current, or there is none.
[[nodiscard]] QString recalibration_reason(const CalibrationRun& run);

/// "With the presses as they are now: 0.021 mm, good (in use: 0.024 mm)."; empty: nothing has
/// changed.
[[nodiscard]] QString forecast_text(const PressForecast& forecast, const CalibrationRun& run);

}  // namespace alltact
