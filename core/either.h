// Lists of alternative words for messages, and the nearest word to a mistyped one.
#pragma once

#include "core/message.h"

#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Returns "a or b or c". The words are those of files and flags, alike in every language.
[[nodiscard]] Message either(const std::vector<std::string>& words);

/// Returns the word with the smallest edit distance to `given`, at most a third of its letters.
/// Otherwise returns an empty string. Two swapped neighbours count as one edit.
[[nodiscard]] std::string nearest_word(std::string_view given,
                                       const std::vector<std::string>& words);

/// Returns "one of a, b, c", preceded by the word that is nearest to `given`.
[[nodiscard]] Message one_of(const std::vector<std::string>& words, std::string_view given = {});

}  // namespace alltact
