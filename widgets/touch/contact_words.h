// Text about the contact.
#pragma once

#include "widgets/number_text.h"
#include "widgets/touch/touch_history.h"

#include <QString>

namespace alltact {

/// Rich text: face and duration of the contact, slip, position on the finger and direction with
/// their standard deviations, extent. Without contact: when the last one ended. `history`: null
/// where frames are not consecutive.
[[nodiscard]] QString contact_words(const FrameResult& result, const TouchHistory* history);

/// Face and force, as measured, on one line; empty where neither is known.
[[nodiscard]] QString brief_contact_words(const FrameResult& result);

/// Origins of the figures, for a tool tip.
[[nodiscard]] QString contact_words_help();

}  // namespace alltact
