#include "widgets/image/image_view.h"

#include "widgets/widget_base.h"

#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr double kWheelFactor = 1.2;  // a notch
constexpr double kKeyFactor = 1.5;
constexpr double kLargest = 64;  // logical pixels per image pixel
constexpr double kPanStep = 40;

QPoint nearest_pixel(QPointF point) {
  return {static_cast<int>(std::lround(point.x())), static_cast<int>(std::lround(point.y()))};
}

/// An image at a screen's own pixels, and the position of the first of these.
struct OnScreen {
  QImage image;
  QPointF at;  // logical pixels
};

/// Reduces bilinearly: Qt takes six times as long for grey images. `shown`: of the widget, logical
/// pixels.
OnScreen reduced(const cv::Mat& grey, const ImageTransform& transform, const QRectF& shown,
                 double device_ratio) {
  const QRectF covered = transform.covered(QSize(grey.cols, grey.rows)).intersected(shown);
  // Pixels of the screen whose centres the image covers.
  const auto first_in = [&](double at) {
    return static_cast<int>(std::ceil(at * device_ratio - 0.5));
  };
  const QPoint first(first_in(covered.left()), first_in(covered.top())),
      end(first_in(covered.right()), first_in(covered.bottom()));
  if (first.x() >= end.x() || first.y() >= end.y()) return {};
  QImage image(end.x() - first.x(), end.y() - first.y(), QImage::Format_Grayscale8);
  cv::Mat pixels(image.height(), image.width(), CV_8UC1, image.bits(),
                 static_cast<std::size_t>(image.bytesPerLine()));
  const auto image_point_of = [&](QPointF device) {
    return transform.to_image((device + QPointF(0.5, 0.5)) / device_ratio);
  };
  const QPointF from = image_point_of(first);
  const double step = 1 / (transform.scale * device_ratio);
  const cv::Matx23d image_from_screen(step, 0, from.x(), 0, step, from.y());
  cv::warpAffine(grey, pixels, image_from_screen, pixels.size(),
                 cv::INTER_LINEAR | cv::WARP_INVERSE_MAP, cv::BORDER_REPLICATE);
  image.setDevicePixelRatio(device_ratio);
  return {image, QPointF(first) / device_ratio};
}

QColor background(const QPalette& palette) { return palette.color(QPalette::Window); }

}  // namespace

ImageView::ImageView(QWidget* parent, CopyFigure::Menu copy_menu) : Translated(parent) {
  new CopyFigure(
      *this, [this] { return grey_.empty() ? QImage() : image_with_overlays(grey_, overlays_); },
      copy_menu);
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setAttribute(Qt::WA_OpaquePaintEvent);
  set_accessible_role(*this, QAccessible::Graphic);
  say([this] {
    setAccessibleName(tr("Image"));
    setWhatsThis(
        tr("The camera's image. The wheel or + and - zoom, 0 shows all of it, 1 its original size. "
           "Drag or use the arrow keys to move it; Shift and the arrow keys move the probe."));
  });
}

void ImageView::show_image(const cv::Mat& grey, std::vector<Overlay> overlays) {
  const bool is_other_size = grey.size() != grey_.size();
  grey_ = grey;
  overlays_ = std::move(overlays);
  message_.clear();
  if (is_other_size) {
    pinned_.reset();
    fit();
  }
  update();
  if (probe()) Q_EMIT probe_changed();
}

void ImageView::show_message(const QString& message) {
  if (grey_.empty() && message_ == message) return;
  grey_ = cv::Mat();
  overlays_.clear();
  hovered_.reset();
  pinned_.reset();
  message_ = message;
  set_accessible_description(*this, message);
  update();
  Q_EMIT probe_changed();
}

std::optional<QPoint> ImageView::probe() const {
  const auto& at = pinned_ ? pinned_ : hovered_;
  if (!at || !QRect(QPoint(), image_size()).contains(*at)) return std::nullopt;
  return at;
}

void ImageView::set_transform(const ImageTransform& transform, bool is_fitted) {
  transform_ = transform.clamped_to(image_size(), size());
  is_fitted_ = is_fitted;
  update();
  Q_EMIT zoom_changed();
}

void ImageView::fit() { set_transform(ImageTransform::fit(image_size(), size()), true); }

void ImageView::show_actual_size() {
  zoom_to(1 / devicePixelRatioF(), QPointF(0.5 * width(), 0.5 * height()));
}

void ImageView::zoom_by(double factor) {
  zoom_to(transform_.scale * factor, QPointF(0.5 * width(), 0.5 * height()));
}

void ImageView::zoom_to(double scale, QPointF fixed) {
  if (grey_.empty()) return;
  const double fitted = ImageTransform::fit(image_size(), size()).scale;
  const double least = std::min(fitted, 1 / devicePixelRatioF());
  scale = std::clamp(scale, least, kLargest);
  set_transform(transform_.zoomed(scale, fixed), scale == fitted);
}

void ImageView::pan(QPointF by) {
  ImageTransform moved = transform_;
  moved.offset += by;
  set_transform(moved, is_fitted_);
}

void ImageView::move_probe(QPoint by) {
  if (grey_.empty()) return;
  const QPoint from =
      probe().value_or(nearest_pixel(transform_.to_image(QPointF(0.5 * width(), 0.5 * height()))));
  const QPoint to = pinned_ ? from + by : from;
  pinned_ = QPoint(std::clamp(to.x(), 0, grey_.cols - 1), std::clamp(to.y(), 0, grey_.rows - 1));
  update();
  Q_EMIT probe_changed();
}

void ImageView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.fillRect(rect(), background(palette()));
  if (grey_.empty()) {
    painter.setPen(palette().color(QPalette::WindowText));
    const QRect room = rect().adjusted(24, 24, -24, -24);
    painter.drawText(room, Qt::AlignCenter | Qt::TextWordWrap, message_);
  } else {
    if (transform_.scale * devicePixelRatioF() < 1) {
      const OnScreen small = reduced(grey_, transform_, rect(), devicePixelRatioF());
      painter.drawImage(small.at, small.image);
      painter.setRenderHint(QPainter::SmoothPixmapTransform);
    } else {
      // Wrapped: grey_ holds the pixels.
      painter.drawImage(transform_.covered(image_size()), grey_image(grey_));
    }
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Overlay& overlay : overlays_) {
      painter.save();
      overlay(painter, transform_);
      painter.restore();
    }
    paint_probe(painter);
  }
  if (hasFocus()) {
    painter.setRenderHint(QPainter::Antialiasing, false);
    painter.setPen(QPen(palette().color(QPalette::Highlight), 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(rect().adjusted(1, 1, -1, -1));
  }
}

void ImageView::paint_probe(QPainter& painter) const {
  if (!pinned_) return;
  const QPointF middle = transform_.to_widget(*pinned_);
  const double half = std::max(6.0, 0.5 * transform_.scale);
  painter.setBrush(Qt::NoBrush);
  for (const auto& [colour, width] :
       {std::pair{QColor(Qt::black), 4.0}, {QColor(Qt::white), 1.5}}) {
    painter.setPen(QPen(colour, width));
    painter.drawRect(QRectF(middle - QPointF(half, half), QSizeF(2 * half, 2 * half)));
    painter.drawLine(middle - QPointF(half + 8, 0), middle - QPointF(half, 0));
    painter.drawLine(middle + QPointF(half, 0), middle + QPointF(half + 8, 0));
    painter.drawLine(middle - QPointF(0, half + 8), middle - QPointF(0, half));
    painter.drawLine(middle + QPointF(0, half), middle + QPointF(0, half + 8));
  }
}

void ImageView::resizeEvent(QResizeEvent* /*event*/) {
  if (is_fitted_)
    fit();
  else
    set_transform(transform_, false);
}

void ImageView::wheelEvent(QWheelEvent* event) {
  const double notches = event->angleDelta().y() / 120.0;
  if (notches == 0) return event->ignore();
  zoom_to(transform_.scale * std::pow(kWheelFactor, notches), event->position());
}

void ImageView::mousePressEvent(QMouseEvent* event) {
  if (event->button() != Qt::LeftButton && event->button() != Qt::MiddleButton) return;
  dragged_from_ = event->position();
  setCursor(Qt::ClosedHandCursor);
}

void ImageView::mouseMoveEvent(QMouseEvent* event) {
  if (dragged_from_) {
    pan(event->position() - *dragged_from_);
    dragged_from_ = event->position();
  }
  hovered_ = nearest_pixel(transform_.to_image(event->position()));
  if (pinned_) {  // the mouse takes over from the keys
    pinned_.reset();
    update();
  }
  Q_EMIT probe_changed();
}

void ImageView::mouseReleaseEvent(QMouseEvent* /*event*/) {
  dragged_from_.reset();
  unsetCursor();
}

void ImageView::mouseDoubleClickEvent(QMouseEvent* /*event*/) { fit(); }

void ImageView::leaveEvent(QEvent* /*event*/) {
  hovered_.reset();
  Q_EMIT probe_changed();
}

void ImageView::keyPressEvent(QKeyEvent* event) {
  const bool moves_probe = event->modifiers().testFlag(Qt::ShiftModifier);
  const auto move = [&](int x, int y) {
    if (moves_probe)
      move_probe({x, y});
    else
      pan(QPointF(-x, -y) * kPanStep);
  };
  switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return zoom_by(kKeyFactor);
    case Qt::Key_Minus:
      return zoom_by(1 / kKeyFactor);
    case Qt::Key_0:
      return fit();
    case Qt::Key_1:
      return show_actual_size();
    case Qt::Key_Left:
      return move(-1, 0);
    case Qt::Key_Right:
      return move(1, 0);
    case Qt::Key_Up:
      return move(0, -1);
    case Qt::Key_Down:
      return move(0, 1);
    case Qt::Key_Escape:
      if (!pinned_) break;
      pinned_.reset();
      update();
      return Q_EMIT probe_changed();
    default:
      break;
  }
  QWidget::keyPressEvent(event);
}

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

QImage image_with_overlays(const cv::Mat& grey, const std::vector<Overlay>& overlays) {
  QImage image = grey_image(grey).convertToFormat(QImage::Format_RGB32);
  QPainter painter(&image);
  painter.setRenderHint(QPainter::Antialiasing);
  for (const Overlay& overlay : overlays) {
    painter.save();
    overlay(painter, ImageTransform());
    painter.restore();
  }
  return image;
}

ImageDialog::ImageDialog(QImage image, QWidget* parent)
    : QDialog(parent), image_(std::move(image)) {
  new CopyFigure(*this, [this] { return image_; });
}

// The image's size, but no larger than the parent window.
QSize ImageDialog::sizeHint() const {
  const QSize max_size =
      parentWidget() != nullptr ? parentWidget()->window()->size() : QSize(1000, 700);
  return image_.width() > max_size.width() || image_.height() > max_size.height()
             ? image_.size().scaled(max_size, Qt::KeepAspectRatio)
             : image_.size();
}

void ImageDialog::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QRect target({}, image_.size().scaled(size(), Qt::KeepAspectRatio));
  target.moveCenter(rect().center());
  painter.drawImage(target, image_);
}

}  // namespace alltact
