#include "widgets/report/press_image.h"

#include "core/geometry/ball.h"
#include "widgets/grey_image.h"

#include <QPainter>
#include <QPainterPath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kRoom = 1.45;  // shown region, in sizes of the outline

/// The hull of all pixels.
QPolygonF border_of(const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<cv::Point2f> points, hull;
  for (const Eigen::Vector2d& pixel : pixels)
    points.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  QPolygonF border;
  if (points.size() < 3) return border;
  cv::convexHull(points, hull);
  for (const cv::Point2f& point : hull)
    border << QPointF(static_cast<double>(point.x), static_cast<double>(point.y));
  return border;
}

/// Visible on any background: a dark line below a light one.
void draw_line(QPainter& painter, const QPainterPath& path, Qt::PenStyle style) {
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 160), 4));
  painter.drawPath(path);
  painter.setPen(QPen(QColor(style == Qt::SolidLine ? "#ffb000" : "#ffffff"), 2, style));
  painter.drawPath(path);
}

}  // namespace

QImage press_image(const cv::Mat& grey,
                   const Camera& camera,
                   const BallFit& ball,
                   const std::vector<Eigen::Vector2d>& contact_pixels,
                   const QSize& size) {
  const auto outline = ball_outline_px(camera, ball.centre_mm, ball.radius_mm, 180);
  if (outline.size() < 3) return full_image(grey, size);
  QPolygonF polygon;
  for (const Eigen::Vector2d& point : outline) polygon << QPointF(point.x(), point.y());
  const QRectF ball_box = polygon.boundingRect();
  // The largest scale at which the region fits into `size` with its proportions.
  const double scale = std::min(size.width() / (kRoom * ball_box.width()),
                                size.height() / (kRoom * ball_box.height()));
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor("#808080"));
  QPainter painter(&image);
  painter.setRenderHints(QPainter::Antialiasing | QPainter::SmoothPixmapTransform);
  // The centre of the top-left pixel is (0, 0); the image's corner is half a pixel before it.
  QTransform to_image;
  to_image.translate(0.5 * size.width(), 0.5 * size.height());
  to_image.scale(scale, scale);
  to_image.translate(-ball_box.center().x(), -ball_box.center().y());
  painter.setTransform(to_image);
  painter.drawImage(QPointF(-0.5, -0.5), grey_image(grey));
  painter.resetTransform();
  QPainterPath path;
  path.addPolygon(to_image.map(polygon));
  path.closeSubpath();
  const auto middle = camera.project(ball.centre_mm);
  if (middle) {
    const QPointF at = to_image.map(QPointF(middle->x(), middle->y()));
    path.moveTo(at - QPointF(5, 0));
    path.lineTo(at + QPointF(5, 0));
    path.moveTo(at - QPointF(0, 5));
    path.lineTo(at + QPointF(0, 5));
  }
  draw_line(painter, path, Qt::SolidLine);
  const QPolygonF border = to_image.map(border_of(contact_pixels));
  QPainterPath contact;
  contact.addPolygon(border);
  contact.closeSubpath();
  if (border.size() > 2) draw_line(painter, contact, Qt::DashLine);
  return image;
}

QImage full_image(const cv::Mat& grey, const QSize& size) {
  QImage image(size, QImage::Format_RGB32);
  image.fill(QColor("#808080"));
  const QImage small = grey_image(grey).scaled(size, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  QPainter painter(&image);
  painter.drawImage(
      (size.width() - small.width()) / 2, (size.height() - small.height()) / 2, small);
  return image;
}

}  // namespace alltact
