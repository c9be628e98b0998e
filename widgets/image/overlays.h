// Overlays of a finger's image. Lines have a dark edge, so that they show on any grey, and the same
// width at any zoom. Different meanings have different shapes.
#pragma once

#include "core/image/colour_map.h"
#include "core/sensing/contact/push.h"
#include "core/sensing/face/face_edges.h"
#include "core/sensing/markers/markers.h"
#include "widgets/image/image_view.h"

#include <QBrush>
#include <QString>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// A line with its dark edge; `width` in logical pixels.
void stroke_over(QPainter& painter, const QPainterPath& path, const QColor& colour, double width,
                 Qt::PenStyle style = Qt::SolidLine);

/// Both edges of the face, broken where they are not known.
[[nodiscard]] Overlay edges_overlay(const FaceEdges& edges);
/// Numbered; a ring for a detected marker, a dashed diamond where its position is an estimate.
[[nodiscard]] Overlay markers_overlay(const Markers& markers);
/// Dots without numbers: small squares.
[[nodiscard]] Overlay dots_overlay(const std::vector<Dot>& dots);
/// An arrow in the direction of the force, from the middle of the markers.
[[nodiscard]] Overlay force_overlay(const Push& push, const Markers& markers);
/// A layer of LiveView, with its first pixel at `at` of the image; an empty one shows
/// nothing.
[[nodiscard]] Overlay layer_overlay(const cv::Mat& layer, cv::Point at = {0, 0});
/// Words on a dark plate at the upper left of the view.
[[nodiscard]] Overlay banner_overlay(const QString& words);
/// The view's border in a bright colour, with words in its middle: something was captured just now.
[[nodiscard]] Overlay flash_overlay(const QString& words);
/// Words on a dark plate next to a point of the image, inside the view; `colour` of the letters.
void write_next_to(QPainter& painter, QPointF widget, const QString& words, const QColor& colour);
/// A pattern drawn over pixels and its meaning.
struct LegendLine {
  QBrush pattern;
  QString words;
};
/// Points at both ends of a colour bar, in the colours of values beyond the scale.
void fill_scale_ends(QPainter& painter, const QRectF& bar);
/// The scale with its numbers, zero marked where it lies within, and above it the legend's lines;
/// at the lower right of the view.
[[nodiscard]] Overlay colour_bar_overlay(const ColourScale& scale, const QString& title,
                                         const std::vector<LegendLine>& legend = {});

}  // namespace alltact
