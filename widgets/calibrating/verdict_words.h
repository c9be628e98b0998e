// A verdict in the window's words, and what changing the presses would make of it.
#pragma once

#include "widgets/calibrating/press_forecast.h"
#include "widgets/theme.h"

#include <optional>

namespace alltact {

[[nodiscard]] QString grade_text(Grade grade);
[[nodiscard]] Meaning meaning_of(Grade grade);
/// A symbol of resources/icons.
[[nodiscard]] QString symbol_name(Meaning meaning);

/// Of one press in the calibration: as kGoodErrorMm and kUsableErrorMm have it.
[[nodiscard]] Meaning meaning_of_error(double error_mm);
/// "good", "fair", "poor".
[[nodiscard]] QString error_word(Meaning meaning);

/// Of the calibration in use; of the stored figures where the whole is not in memory.
[[nodiscard]] std::optional<Verdict> verdict_of(const CalibrationRun& run);

/// "With the presses as they are now: 0.021 mm, good (in use: 0.024 mm)."; empty: there is nothing
/// to say, because nothing has changed.
[[nodiscard]] QString forecast_text(const PressForecast& forecast, const CalibrationRun& run);

}  // namespace alltact
