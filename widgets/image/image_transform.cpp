#include "widgets/image/image_transform.h"

#include <algorithm>

namespace alltact {
namespace {

double clamped_offset(double offset, double covered, double room) {
  if (covered <= room) return 0.5 * (room - covered);
  return std::clamp(offset, room - covered, 0.0);
}

}  // namespace

ImageTransform ImageTransform::fit(QSize image, QSizeF widget) {
  if (image.isEmpty() || widget.isEmpty()) return {};
  ImageTransform transform;
  transform.scale = std::min(widget.width() / image.width(), widget.height() / image.height());
  return transform.clamped_to(image, widget);
}

ImageTransform ImageTransform::zoomed(double new_scale, QPointF fixed) const {
  ImageTransform transform;
  transform.scale = new_scale;
  transform.offset = fixed - (fixed - offset) * (new_scale / scale);
  return transform;
}

ImageTransform ImageTransform::clamped_to(QSize image, QSizeF widget) const {
  ImageTransform transform = *this;
  const QSizeF covered = QSizeF(image) * scale;
  transform.offset = {clamped_offset(offset.x(), covered.width(), widget.width()),
                      clamped_offset(offset.y(), covered.height(), widget.height())};
  return transform;
}

}  // namespace alltact
