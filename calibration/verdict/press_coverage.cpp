#include "calibration/verdict/press_coverage.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace alltact {
namespace {

bool is_before(const ContactSpot& a, const ContactSpot& b) {
  return std::tie(a.along_mm, a.across_mm, a.radius_mm) <
         std::tie(b.along_mm, b.across_mm, b.radius_mm);
}

bool is_same_position(const ContactSpot& a, const ContactSpot& b) {
  return std::hypot(a.along_mm - b.along_mm, a.across_mm - b.across_mm) <=
         std::max(a.radius_mm, b.radius_mm);
}

}  // namespace

std::vector<int> position_numbers(const std::vector<ContactSpot>& spots) {
  std::vector<std::size_t> order(spots.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return is_before(spots[i], spots[j]);
  });
  std::vector<int> numbers(spots.size(), 0);
  std::vector<std::size_t> first;  // of each position
  for (const std::size_t i : order) {
    const auto same = std::find_if(first.begin(), first.end(), [&](std::size_t other) {
      return is_same_position(spots[i], spots[other]);
    });
    numbers[i] = static_cast<int>(same - first.begin());
    if (same == first.end()) first.push_back(i);
  }
  return numbers;
}

PressCoverage coverage_of(std::vector<ContactSpot> spots) {
  std::sort(spots.begin(), spots.end(), is_before);
  const std::vector<int> numbers = position_numbers(spots);
  std::vector<ContactSpot> distinct;
  PressCoverage coverage;
  double length_mm = 0;
  for (std::size_t i = 0; i < spots.size(); ++i) {
    const ContactSpot& spot = spots[i];
    length_mm = std::max(length_mm, spot.face_length_mm);
    if (std::find(numbers.begin(), numbers.begin() + static_cast<std::ptrdiff_t>(i), numbers[i]) !=
        numbers.begin() + static_cast<std::ptrdiff_t>(i))
      continue;
    distinct.push_back(spot);
    if (!(spot.face_length_mm > 0)) continue;
    const int third = static_cast<int>(std::floor(3.0 * spot.along_mm / spot.face_length_mm));
    ++coverage.thirds[static_cast<std::size_t>(std::clamp(third, 0, 2))];
  }
  coverage.positions = static_cast<int>(distinct.size());
  if (distinct.size() < 2 || !(length_mm > 0)) return coverage;
  const auto n = static_cast<double>(distinct.size());
  double mean = 0, squares = 0;
  for (const ContactSpot& spot : distinct) mean += spot.along_mm / n;
  for (const ContactSpot& spot : distinct)
    squares += (spot.along_mm - mean) * (spot.along_mm - mean);
  // Over a face from 0 to its length.
  const double apart = 0.5 * length_mm - mean;
  const double mean_square = apart * apart + length_mm * length_mm / 12;
  coverage.leverage =
      std::min(kMaxLeverage, 1 / n + (squares > 0 ? mean_square / squares : kMaxLeverage));
  return coverage;
}

}  // namespace alltact
