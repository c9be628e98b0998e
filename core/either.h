// Which words there are to choose from.
#pragma once

#include "core/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// "a or b or c"; the words themselves are those of files and flags, alike in every language.
[[nodiscard]] Message either(const std::vector<std::string>& words);

/// The word that differs least from what was given, where at most a third of its letters do; else
/// empty. Two neighbours that changed places count as one.
[[nodiscard]] std::string nearest_word(std::string_view given,
                                       const std::vector<std::string>& words);

/// "one of a, b, c", with the word that is nearest to what was given before it.
[[nodiscard]] Message one_of(const std::vector<std::string>& words, std::string_view given = {});

}  // namespace alltact
