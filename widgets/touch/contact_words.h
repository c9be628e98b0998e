// What touches the finger, in words.
#pragma once

#include "widgets/touch/touch_history.h"

#include <QString>

namespace alltact {

/// Rich text: which face and since when, slip, place on the finger and direction with their
/// standard deviations, extent; or that nothing touches, and when that ended. `history`: null where
/// frames do not follow each other.
[[nodiscard]] QString contact_words(const FrameResult& result, const TouchHistory* history);

/// Face and force, as measured, on one line; empty where nothing is told.
[[nodiscard]] QString brief_touch_words(const FrameResult& result);

/// What the figures count from, for a tool tip.
[[nodiscard]] QString contact_words_help();

/// Without "-0.0".
[[nodiscard]] QString plain_number(double value, int digits);
/// "1.23 ± 0.04" as rich text, without the latter where it is not known; "1.23 ± <0.01" where the
/// digits would make it none.
[[nodiscard]] QString number_and_sd(double value, const std::optional<double>& sd, int digits);

}  // namespace alltact
