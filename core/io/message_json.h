// Messages as JSON, for files and other processes that are to say them in their own language.
#pragma once

#include "core/message.h"

#include <nlohmann/json_fwd.hpp>

namespace alltact {

/// Text is {"text": t}, a number {"number": "0.12"}; what was said {"say": template, "parts":
/// [...]}; with "of" where a word belongs to something; what was counted {"count": n, "many":
/// template, "one": template, "parts": [...]}. Nothing said is {"text": ""}.
[[nodiscard]] nlohmann::ordered_json message_json(const Message& message);

/// The way back; whatever has another form is taken as the text it is.
[[nodiscard]] Message message_of(const nlohmann::ordered_json& json);

}  // namespace alltact
