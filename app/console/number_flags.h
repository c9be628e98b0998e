// Numbers of flags: core/typed_number.h parses every one. Use
// `add_option(...)->transform(typed_number(0.1, 100))` instead of CLI11's own checks.
#pragma once

#include "core/finger/quantity.h"
#include "core/message.h"
#include "core/result.h"

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace alltact {

/// From `low` to `high`, for any floating-point option.
[[nodiscard]] CLI::Validator typed_number(double low, double high);
/// A possible value; one that is not plausible is added to number_warnings().
[[nodiscard]] CLI::Validator typed_number(const Quantity& quantity);
/// From `low` to `high`, for any integral option.
[[nodiscard]] CLI::Validator typed_integer(
    std::uint64_t low, std::uint64_t high = std::numeric_limits<std::uint64_t>::max());

/// Of the numbers on the command line that was read last: "--layer-mm: ...".
[[nodiscard]] std::vector<Message>& number_warnings();

/// Texts of numbers between commas or, where one has a decimal comma, semicolons: "0,5;2;1,49".
/// Error: not `count` of them.
[[nodiscard]] Result<std::vector<double>> typed_numbers(std::string_view text, std::size_t count);

}  // namespace alltact
