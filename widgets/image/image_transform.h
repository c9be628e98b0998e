// Transform between an image's pixels and a widget.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSizeF>

namespace alltact {

/// Image coordinates have the centre of the top-left pixel at (0, 0), so that the image covers
/// [-0.5, width - 0.5] by [-0.5, height - 0.5]; widget coordinates are Qt's logical pixels.
///   widget = (image + 0.5) * scale + offset
struct ImageTransform {
  double scale = 1;  ///< logical pixels per image pixel, > 0
  QPointF offset;    ///< of the top-left pixel's outer corner

  [[nodiscard]] QPointF to_widget(QPointF image) const {
    return (image + QPointF(0.5, 0.5)) * scale + offset;
  }
  [[nodiscard]] QPointF to_image(QPointF widget) const {
    return (widget - offset) / scale - QPointF(0.5, 0.5);
  }
  /// The area of the full image in the widget.
  [[nodiscard]] QRectF covered(QSize image) const { return {offset, QSizeF(image) * scale}; }

  /// The full image as large as it fits, centred.
  [[nodiscard]] static ImageTransform fit(QSize image, QSizeF widget);
  /// The same with another scale; the image point under `fixed` does not move.
  [[nodiscard]] ImageTransform zoomed(double new_scale, QPointF fixed) const;
  /// Moved as little as needed: an image larger than the widget leaves no gap at its sides, a
  /// smaller one is centred.
  [[nodiscard]] ImageTransform clamped_to(QSize image, QSizeF widget) const;
};

}  // namespace alltact
