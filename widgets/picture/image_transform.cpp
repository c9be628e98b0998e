#include "widgets/picture/image_transform.h"

#include <algorithm>

namespace alltact {
namespace {

double kept_offset(double offset, double covered, double room) {
  if (covered <= room) return 0.5 * (room - covered);
  return std::clamp(offset, room - covered, 0.0);
}

}  // namespace

ImageTransform ImageTransform::fit(QSize picture, QSizeF widget) {
  if (picture.isEmpty() || widget.isEmpty()) return {};
  ImageTransform transform;
  transform.scale = std::min(widget.width() / picture.width(), widget.height() / picture.height());
  return transform.kept_in(picture, widget);
}

ImageTransform ImageTransform::zoomed(double new_scale, QPointF fixed) const {
  ImageTransform transform;
  transform.scale = new_scale;
  transform.offset = fixed - (fixed - offset) * (new_scale / scale);
  return transform;
}

ImageTransform ImageTransform::kept_in(QSize picture, QSizeF widget) const {
  ImageTransform transform = *this;
  const QSizeF covered = QSizeF(picture) * scale;
  transform.offset = {kept_offset(offset.x(), covered.width(), widget.width()),
                      kept_offset(offset.y(), covered.height(), widget.height())};
  return transform;
}

}  // namespace alltact
