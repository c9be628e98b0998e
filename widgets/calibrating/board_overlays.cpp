#include "widgets/calibrating/board_overlays.h"

#include "widgets/image/overlays.h"

#include <QPainter>
#include <QPainterPath>

namespace alltact {
namespace {

const QColor kCorner(255, 214, 64), kAccepted(47, 199, 155), kGrid(86, 180, 233);
constexpr double kCornerRing = 4;  // logical pixels
constexpr double kGridStep = 0.1;  // of a tangent
constexpr int kGridLines = 12;     // on each side
constexpr int kGridPoints = 96;

/// A world line at z = 1, interrupted where it is outside the image.
QPainterPath seen_line(const Camera& camera,
                       double fixed,
                       bool is_upright,
                       const ImageTransform& t) {
  QPainterPath path;
  bool is_drawing = false;
  constexpr double kReach = kGridLines * kGridStep;
  const cv::Size size = camera.size();
  for (int i = 0; i <= kGridPoints; ++i) {
    const double along = -kReach + 2 * kReach * i / kGridPoints;
    const Eigen::Vector3d point =
        is_upright ? Eigen::Vector3d(fixed, along, 1) : Eigen::Vector3d(along, fixed, 1);
    const auto pixel = camera.project(100 * point);
    const bool is_seen = pixel && pixel->x() > -20 && pixel->y() > -20 &&
                         pixel->x() < size.width + 20 && pixel->y() < size.height + 20;
    if (is_seen) {
      const QPointF at = t.to_widget({pixel->x(), pixel->y()});
      if (is_drawing)
        path.lineTo(at);
      else
        path.moveTo(at);
    }
    is_drawing = is_seen;
  }
  return path;
}

}  // namespace

Overlay corners_overlay(const BoardAnalysis& detection) {
  return [view = *detection.view, is_good = detection.is_useful()](
             QPainter& painter, const ImageTransform& transform) {
    QPainterPath path;
    for (const Eigen::Vector2d& pixel : view.pixels)
      path.addEllipse(transform.to_widget({pixel.x(), pixel.y()}), kCornerRing, kCornerRing);
    if (is_good) painter.fillPath(path, kAccepted);
    stroke_over(painter, path, is_good ? kAccepted : kCorner, 1.4);
  };
}

Overlay unseen_cells_overlay(const BoardCollector::Cells& cells, QSize image_size) {
  return [cells, image_size](QPainter& painter, const ImageTransform& transform) {
    const QRectF area = transform.covered(image_size);
    const double width = area.width() / BoardCollector::kColumns;
    const double height = area.height() / BoardCollector::kRows;
    for (int row = 0; row < BoardCollector::kRows; ++row)
      for (int column = 0; column < BoardCollector::kColumns; ++column)
        if (cells[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] == 0)
          painter.fillRect(
              QRectF(area.left() + column * width, area.top() + row * height, width, height)
                  .adjusted(2, 2, -2, -2),
              QBrush(QColor(240, 145, 90, 130), Qt::BDiagPattern));
  };
}

Overlay lens_grid_overlay(const Camera& camera) {
  return [camera](QPainter& painter, const ImageTransform& transform) {
    if (!camera.is_perspective()) return;
    const cv::Size size = camera.size();
    painter.setClipRect(transform.covered({size.width, size.height}));
    QPainterPath path;
    for (int line = -kGridLines; line <= kGridLines; ++line)
      for (const bool is_upright : {true, false})
        path.addPath(seen_line(camera, line * kGridStep, is_upright, transform));
    QColor colour = kGrid;
    colour.setAlpha(150);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colour, 1));
    painter.drawPath(path);
  };
}

}  // namespace alltact
