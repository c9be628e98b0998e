#include "widgets/plots/label_places.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr double kApart = 3;                                          // px, of two labels
constexpr std::array kDistances{9.0, 22.0, 38.0, 58.0, 84.0, 116.0};  // px
/// Of the label's middle from the dot: upwards is where whiskers are and nothing else.
constexpr std::array<std::array<double, 2>, 8> kWays{
    {{1, 0}, {1, -0.7}, {-1, -0.7}, {0.4, -1}, {-0.4, -1}, {-1, 0}, {1, 0.7}, {-1, 0.7}}};

QRectF beside(const WantedLabel& label, const std::array<double, 2>& way, double distance) {
  const QPointF middle(label.dot.x() + way[0] * (distance + 0.5 * label.size.width()),
                       label.dot.y() + way[1] * (distance + 0.5 * label.size.height()));
  return {middle - QPointF(0.5 * label.size.width(), 0.5 * label.size.height()), label.size};
}

}  // namespace

std::vector<std::optional<QRectF>> place_labels(const QRectF& room,
                                                const std::vector<WantedLabel>& labels,
                                                const std::vector<QRectF>& taken) {
  std::vector<QRectF> occupied = taken;
  std::vector<std::optional<QRectF>> places;
  const auto is_free = [&](const QRectF& place) {
    const QRectF wide = place.adjusted(-kApart, -kApart, kApart, kApart);
    return room.contains(place) &&
           std::none_of(occupied.begin(), occupied.end(), [&](const QRectF& other) {
             return wide.intersects(other);
           });
  };
  for (const WantedLabel& label : labels) {
    std::optional<QRectF> found;
    for (const double distance : kDistances)
      for (const auto& way : kWays) {
        const QRectF place = beside(label, way, distance);
        if (!found && is_free(place)) found = place;
      }
    if (found) occupied.push_back(*found);
    places.push_back(found);
  }
  return places;
}

}  // namespace alltact
