#include "core/simulation/marker_numbers.h"

#include <algorithm>
#include <cmath>

namespace alltact {

namespace {

constexpr std::size_t kMaxMarkers = 128;

}  // namespace

std::vector<std::size_t> read_marker_numbers(YamlSection& section) {
  std::vector<std::size_t> numbers;
  for (const double given : section.numbers("markers", 1, kMaxMarkers, {-1e6, 1e6})) {
    if (given < 0 || given != std::floor(given))
      section.refuse(
          "markers", en::say("{:g} is not a marker's number", given), en::say("0, 1, 2, ..."));
    const auto number = static_cast<std::size_t>(given);
    if (std::find(numbers.begin(), numbers.end(), number) != numbers.end())
      section.refuse(
          "markers", en::say("marker {} is listed twice", number), en::say("each number once"));
    numbers.push_back(number);
  }
  return numbers;
}

}  // namespace alltact
