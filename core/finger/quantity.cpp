#include "core/finger/quantity.h"

#include <string>

namespace alltact {

std::optional<Message> Quantity::refusal(double value) const {
  if (possible.holds(value)) return std::nullopt;
  return en::say(
      "must be a number from {:g} to {:g} {}", possible.low, possible.high, std::string(unit));
}

std::optional<Message> Quantity::warning(double value) const {
  if (auto refused = refusal(value)) return refused;
  if (plausible.holds(value)) return std::nullopt;
  const std::string unit_text(unit);
  const Message of = meaning();
  if (value > plausible.high)
    return en::say("{:g} {} is more than usual for {} ({:g} to {:g} {}): check the decimal mark",
                   value,
                   unit_text,
                   of,
                   plausible.low,
                   plausible.high,
                   unit_text);
  return en::say("{:g} {} is less than usual for {} ({:g} to {:g} {}): check the decimal mark",
                 value,
                 unit_text,
                 of,
                 plausible.low,
                 plausible.high,
                 unit_text);
}

}  // namespace alltact
