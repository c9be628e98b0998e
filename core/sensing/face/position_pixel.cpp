#include "core/sensing/face/position_pixel.h"

#include <algorithm>
#include <cmath>

namespace alltact {

std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                 const Eigen::Vector2d& position_mm) {
  const auto& columns = shape.columns();
  const auto is_valid = [](const FaceColumn& c) { return c.valid; };
  long low = std::find_if(columns.begin(), columns.end(), is_valid) - columns.begin();
  long high = columns.rend() - std::find_if(columns.rbegin(), columns.rend(), is_valid) - 1;
  if (high <= low) return std::nullopt;
  // Lengths increase from base to tip, which may be from right to left.
  const auto ahead_mm = [&](long u) {
    const double by = position_mm.x() - shape.length_at(static_cast<double>(u));
    return shape.base_at_low_u() ? by : -by;
  };
  if (!(ahead_mm(low) >= 0.0) || !(ahead_mm(high) <= 0.0)) return std::nullopt;
  while (high - low > 1) {
    const long middle = low + (high - low) / 2;
    (ahead_mm(middle) >= 0.0 ? low : high) = middle;
  }
  const double span_mm = ahead_mm(low) - ahead_mm(high);
  const double u = static_cast<double>(low) + (span_mm > 0.0 ? ahead_mm(low) / span_mm : 0.0);
  const FaceColumn& column = columns[static_cast<std::size_t>(std::lround(u))];
  if (!column.valid) return std::nullopt;
  return Eigen::Vector2d(u,
                         0.5 * (column.upper_v + column.lower_v) +
                             position_mm.y() / shape.camera().mm_per_px_at(column.z_mm));
}

}  // namespace alltact
