// The faces of a finger.
#pragma once

#include <string_view>

namespace alltact {

/// Upper is the side face at small v (y < 0), lower the one at large v.
enum class PushedFace { kContact = 1, kBack, kUpper, kLower };
[[nodiscard]] std::string_view to_string(PushedFace face);

}  // namespace alltact
