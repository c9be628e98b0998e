// Layout of labels next to their dots without overlaps.
#pragma once

#include <QRectF>
#include <optional>
#include <vector>

namespace alltact {

struct LabelRequest {
  QPointF dot;
  QSizeF size;
};

/// Arranges one label after the other, the most important first, each as near to its dot as there
/// is room; all in px. nullopt: there is no room near enough.
///   room: where labels may stand; taken: boxes that they must not cover
[[nodiscard]] std::vector<std::optional<QRectF>> layout_labels(
    const QRectF& room, const std::vector<LabelRequest>& labels, const std::vector<QRectF>& taken);

}  // namespace alltact
