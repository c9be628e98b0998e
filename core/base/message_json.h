// Messages as JSON, for files and for processes that show them in their own language.
#pragma once

#include "core/base/message.h"

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// Text is {"text": t}, a number {"number": "0.12"}; a template {"say": template, "parts": [...]},
/// with "of" where a word describes something; a count {"count": n, "many": template, "one":
/// template, "parts": [...]}. An empty message is {"text": ""}.
[[nodiscard]] nlohmann::ordered_json message_json(const Message& message);

/// The inverse; any other form becomes its text.
[[nodiscard]] Message message_of(const nlohmann::ordered_json& json);

}  // namespace alltact
