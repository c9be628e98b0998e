#include "app/console/flags.h"

#include "core/base/message.h"
#include "core/base/typed_number.h"

#include <algorithm>
#include <charconv>

#include <fmt/format.h>

namespace alltact {
namespace {

/// The refusal; empty for an accepted number: then `text` is as CLI11 reads it.
std::string refusal_of(const Result<std::string>& plain, std::string& text) {
  if (!plain) return plain.error().what.english();
  text = *plain;
  return {};
}

double value_of_plain(const std::string& plain) {
  double value = 0;
  std::from_chars(plain.data(), plain.data() + plain.size(), value);
  return value;
}

}  // namespace

CLI::Validator typed_number(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& text) {
        std::string refused = refusal_of(plain_number(text), text);
        if (!refused.empty()) return refused;
        const double value = value_of_plain(text);
        if (value >= low && value <= high) return std::string();
        return fmt::format("must be a number from {:g} to {:g}, not {}", low, high, text);
      },
      fmt::format("NUMBER from {:g} to {:g}", low, high));
}

CLI::Validator typed_number(const Quantity& quantity) {
  return CLI::Validator(
      [&quantity](std::string& text) {
        const NumberFormat writing{DecimalMark::kPoint, std::string(quantity.unit)};
        std::string refused = refusal_of(plain_number(text, writing), text);
        if (!refused.empty()) return refused;
        const double value = value_of_plain(text);
        if (const auto problem = quantity.refusal(value))
          return fmt::format("{}, not {}", *problem, text);
        if (const auto warning = quantity.warning(value)) number_warnings().push_back(*warning);
        return std::string();
      },
      fmt::format("NUMBER from {:g} to {:g}", quantity.possible.low, quantity.possible.high));
}

CLI::Validator typed_integer(std::uint64_t low, std::uint64_t high) {
  const bool is_bounded = high < std::numeric_limits<std::uint64_t>::max();
  return CLI::Validator(
      [low, high](std::string& text) {
        std::string refused = refusal_of(plain_integer(text), text);
        if (!refused.empty()) return refused;
        std::uint64_t value = 0;
        const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
        if (read.ec == std::errc{} && read.ptr == text.data() + text.size() && value >= low &&
            value <= high)
          return std::string();
        return fmt::format("must be an integer from {} to {}, not {}", low, high, text);
      },
      is_bounded ? fmt::format("NUMBER from {} to {}", low, high) : "NUMBER");
}

std::vector<Message>& number_warnings() {
  static std::vector<Message> warnings;
  return warnings;
}

Result<std::vector<double>> typed_numbers(std::string_view text, std::size_t count) {
  const char between = text.find(';') != std::string_view::npos ? ';' : ',';
  std::vector<double> numbers;
  for (std::string_view rest = text;;) {
    const std::size_t end = std::min(rest.find(between), rest.size());
    const auto number = parse_typed_number(rest.substr(0, end));
    if (!number) return number.error();
    numbers.push_back(*number);
    if (end == rest.size()) break;
    rest.remove_prefix(end + 1);
  }
  if (numbers.size() == count) return numbers;
  return Error{Message::typed(fmt::format("'{}' holds {} numbers, not {}: write decimals with a "
                                          "point, or separate the numbers with semicolons",
                                          printable(text), numbers.size(), count)),
               "", ""};
}

}  // namespace alltact
