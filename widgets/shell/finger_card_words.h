// The summary of a finger as text in the window's language.
#pragma once

#include "widgets/shell/finger_card.h"
#include "widgets/verdict_text.h"

#include <QString>

namespace alltact {

/// "Good, ±0.035 mm", "Broken", "Not calibrated yet"; kGood only where nothing is due.
[[nodiscard]] Headline headline_of(const FingerCard& card);
/// The date in the local time zone and format; empty for no date.
[[nodiscard]] QString local_day(const std::string& utc);
/// "today", "yesterday", "3 days ago", by local days; empty for no date.
[[nodiscard]] QString age_in_days(const std::string& utc, const std::string& now);
/// Dates of calibration and check; empty for never.
[[nodiscard]] QString dates_of(const FingerCard& card);
[[nodiscard]] QString due_text(const FingerCard& card);
/// Contradictions and missing requirements of the calibration, one sentence a line; empty: none.
[[nodiscard]] QString findings_text(const FingerCard& card);
/// One line: grade, expected error, ages of calibration and check, error in the check, what is due.
[[nodiscard]] QString summary_of(const FingerCard& card, const std::string& now);

}  // namespace alltact
