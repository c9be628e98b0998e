#include "core/recording/time_match.h"

#include <algorithm>

namespace alltact {

MatchedFrame match_frame(std::size_t number,
                         const FrameTimes& times_ns,
                         const FrameTimes& other_times_ns,
                         std::size_t other_count) {
  if (number >= times_ns.size() || other_times_ns.empty())
    return {std::min(number, other_count - 1), MatchedBy::kNumber, 0};
  const auto [first, last] = std::minmax_element(times_ns.begin(), times_ns.end());
  const auto [other_first, other_last] =
      std::minmax_element(other_times_ns.begin(), other_times_ns.end());
  const bool is_one_time = *first <= *other_last && *other_first <= *last;
  const std::int64_t shift_ns = is_one_time ? 0 : *other_first - *first;
  const std::int64_t target_ns = times_ns[number] + shift_ns;
  const auto nearest = std::min_element(
      other_times_ns.begin(), other_times_ns.end(), [&](std::int64_t a, std::int64_t b) {
        return std::abs(a - target_ns) < std::abs(b - target_ns);
      });
  return {static_cast<std::size_t>(nearest - other_times_ns.begin()),
          is_one_time ? MatchedBy::kTime : MatchedBy::kBeginning,
          1e-6 * static_cast<double>(*nearest - target_ns)};
}

}  // namespace alltact
