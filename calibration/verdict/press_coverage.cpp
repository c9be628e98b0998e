#include "calibration/verdict/press_coverage.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace alltact {
namespace {

bool is_same_position(const ContactSpot& a, const ContactSpot& b) {
  return std::hypot(a.along_mm - b.along_mm, a.across_mm - b.across_mm) <=
         std::max(a.radius_mm, b.radius_mm);
}

}  // namespace

PressCoverage coverage_of(std::vector<ContactSpot> spots) {
  std::sort(spots.begin(), spots.end(), [](const ContactSpot& a, const ContactSpot& b) {
    return std::tie(a.along_mm, a.across_mm, a.radius_mm) <
           std::tie(b.along_mm, b.across_mm, b.radius_mm);
  });
  std::vector<ContactSpot> distinct;
  PressCoverage coverage;
  double length_mm = 0;
  for (const ContactSpot& spot : spots) {
    length_mm = std::max(length_mm, spot.face_length_mm);
    if (std::any_of(distinct.begin(), distinct.end(), [&](const ContactSpot& other) {
          return is_same_position(spot, other);
        }))
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
  const double wanted = apart * apart + length_mm * length_mm / 12;
  coverage.leverage =
      std::min(kMostLeverage, 1 / n + (squares > 0 ? wanted / squares : kMostLeverage));
  return coverage;
}

}  // namespace alltact
