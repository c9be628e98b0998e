// What is known of a finger, in the window's words.
#pragma once

#include "widgets/shell/finger_card.h"
#include "widgets/worth_words.h"

#include <QString>

namespace alltact {

/// "Good, ±0.035 mm", "Broken", "Not calibrated yet"; its meaning is good only where nothing is
/// due.
[[nodiscard]] Headline headline_of(const FingerCard& card);
/// Where it is, as people there write it; empty for no date.
[[nodiscard]] QString local_day(const std::string& utc);
/// "today", "yesterday", "3 days ago", by the days of where it is; empty for no date.
[[nodiscard]] QString age_in_days(const std::string& utc, const std::string& now);
/// When it was calibrated and checked; empty for never.
[[nodiscard]] QString dates_of(const FingerCard& card);
[[nodiscard]] QString due_text(const FingerCard& card);
/// What contradicts the calibration and what it lacks, a sentence a line; empty: nothing.
[[nodiscard]] QString findings_text(const FingerCard& card);
/// All of it in a line: worth, error to be expected, ages of calibration and check, what the check
/// was off by, what is due.
[[nodiscard]] QString summary_of(const FingerCard& card, const std::string& now);

}  // namespace alltact
