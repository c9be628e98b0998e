#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace alltact {

/// The median of the values, for an even number the upper of the two in the middle; 0 for none.
/// Reorders them. Values must be comparable: no NaN.
template <class T>
[[nodiscard]] T upper_median(std::vector<T>& values) {
  if (values.empty()) return T{};
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace alltact
