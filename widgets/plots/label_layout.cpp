#include "widgets/plots/label_layout.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr double kApart = 3;                                          // px, of two labels
constexpr std::array kDistances{9.0, 22.0, 38.0, 58.0, 84.0, 116.0};  // px
/// Direction from the dot to the label's middle: upwards first, where only whiskers are.
constexpr std::array<std::array<double, 2>, 8> kDirections{
    {{1, 0}, {1, -0.7}, {-1, -0.7}, {0.4, -1}, {-0.4, -1}, {-1, 0}, {1, 0.7}, {-1, 0.7}}};

QRectF box_next_to(const LabelRequest& label,
                   const std::array<double, 2>& direction,
                   double distance) {
  const QPointF middle(label.dot.x() + direction[0] * (distance + 0.5 * label.size.width()),
                       label.dot.y() + direction[1] * (distance + 0.5 * label.size.height()));
  return {middle - QPointF(0.5 * label.size.width(), 0.5 * label.size.height()), label.size};
}

}  // namespace

std::vector<std::optional<QRectF>> layout_labels(const QRectF& room,
                                                 const std::vector<LabelRequest>& labels,
                                                 const std::vector<QRectF>& taken) {
  std::vector<QRectF> occupied = taken;
  std::vector<std::optional<QRectF>> boxes;
  const auto is_free = [&](const QRectF& box) {
    const QRectF wide = box.adjusted(-kApart, -kApart, kApart, kApart);
    return room.contains(box) &&
           std::none_of(occupied.begin(), occupied.end(), [&](const QRectF& other) {
             return wide.intersects(other);
           });
  };
  for (const LabelRequest& label : labels) {
    std::optional<QRectF> found;
    for (const double distance : kDistances)
      for (const auto& direction : kDirections) {
        const QRectF box = box_next_to(label, direction, distance);
        if (!found && is_free(box)) found = box;
      }
    if (found) occupied.push_back(*found);
    boxes.push_back(found);
  }
  return boxes;
}

}  // namespace alltact
