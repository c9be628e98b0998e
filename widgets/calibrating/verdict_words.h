// What the calibration in use is worth, and what changing the presses would make of it.
#pragma once

#include "widgets/calibrating/press_forecast.h"
#include "widgets/worth_words.h"

#include <optional>

namespace alltact {

/// Of the calibration in use, as its folder stands now; nullopt: there is none, or nothing is
/// stored of how it came about.
[[nodiscard]] std::optional<Verdict> verdict_of(const CalibrationRun& run);

/// Why it has to be made again, sentences; empty: it is current, or there is none.
[[nodiscard]] QString why_again(const CalibrationRun& run);

/// "With the presses as they are now: 0.021 mm, good (in use: 0.024 mm)."; empty: there is nothing
/// to say, because nothing has changed.
[[nodiscard]] QString forecast_text(const PressForecast& forecast, const CalibrationRun& run);

}  // namespace alltact
