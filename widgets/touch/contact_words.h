// What touches the finger, in words.
#pragma once

#include "widgets/number_text.h"
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

}  // namespace alltact
