// What the libraries say, in the window's language.
#pragma once

#include "core/message.h"

#include <QString>

namespace alltact {

/// GUI thread only.
[[nodiscard]] QString in_window_language(const Message& message);

/// The same, as one to begin a line with: a capital first and a full stop last.
[[nodiscard]] QString window_sentence(const Message& message);

}  // namespace alltact
