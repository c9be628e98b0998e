// Where words go beside the dots they name, so that no two lie over each other.
#pragma once

#include <QRectF>
#include <optional>
#include <vector>

namespace alltact {

struct WantedLabel {
  QPointF dot;
  QSizeF size;
};

/// One after the other, the most important first, each as near to its dot as there is room. All
/// px. nullopt: there is no room near enough.
///   room: where labels may stand; taken: what they must not cover
[[nodiscard]] std::vector<std::optional<QRectF>> place_labels(
    const QRectF& room, const std::vector<WantedLabel>& labels, const std::vector<QRectF>& taken);

}  // namespace alltact
