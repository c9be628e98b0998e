// Where a picture's pixels lie in a widget.
#pragma once

#include <QPointF>
#include <QRectF>
#include <QSize>
#include <QSizeF>

namespace alltact {

/// Picture coordinates have the centre of the top-left pixel at (0, 0), so that the picture covers
/// [-0.5, width - 0.5] by [-0.5, height - 0.5]; widget coordinates are Qt's logical pixels.
///   widget = (picture + 0.5) * scale + offset
struct ImageTransform {
  double scale = 1;  ///< logical pixels a picture pixel is wide, > 0
  QPointF offset;    ///< of the top-left pixel's outer corner

  [[nodiscard]] QPointF to_widget(QPointF picture) const {
    return (picture + QPointF(0.5, 0.5)) * scale + offset;
  }
  [[nodiscard]] QPointF to_picture(QPointF widget) const {
    return (widget - offset) / scale - QPointF(0.5, 0.5);
  }
  /// What the whole picture covers.
  [[nodiscard]] QRectF covered(QSize picture) const { return {offset, QSizeF(picture) * scale}; }

  /// The whole picture as large as it goes, in the middle.
  [[nodiscard]] static ImageTransform fit(QSize picture, QSizeF widget);
  /// The same with another scale, the picture point under `fixed` staying where it is.
  [[nodiscard]] ImageTransform zoomed(double new_scale, QPointF fixed) const;
  /// Moved as little as needed: a picture larger than the widget leaves no gap at its sides, a
  /// smaller one lies in the middle.
  [[nodiscard]] ImageTransform kept_in(QSize picture, QSizeF widget) const;
};

}  // namespace alltact
