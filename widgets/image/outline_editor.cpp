#include "widgets/image/outline_editor.h"

#include "core/geometry/ball.h"
#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/widget_base.h"

#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace alltact {
namespace {

constexpr int kDrawnPoints = 240;
constexpr int kMeasuredPoints = 2400;  // whose chords lie within a ten-thousandth of a pixel
constexpr double kReach = 9;           // logical pixels around a handle that grab it
constexpr double kFineStep_px = 0.1, kCoarseStep_px = 1;
constexpr double kSlanted = 0.05;     // cosine; a plane seen flatter than this recedes too fast
constexpr double kMinOutline_px = 2;  // a smaller outline cannot be grabbed
constexpr int kOneRun_ms = 1000;      // steps within this time are one
constexpr double kLoupe = 168, kLoupeGap = 26, kLoupeScale = 10;
const QColor kOutline(255, 214, 64);

QPointF to_point(const Eigen::Vector2d& v) { return {v.x(), v.y()}; }

double distance(QPointF a, QPointF b) { return std::hypot(a.x() - b.x(), a.y() - b.y()); }

std::vector<QPointF> outline_of(const ShownBall& ball, int count) {
  std::vector<QPointF> points;
  for (const auto& p : ball_outline_px(ball.camera, ball.centre_mm, ball.radius_mm, count))
    points.push_back(to_point(p));
  return points;
}

/// The crossing of a polygon with the row of `centre` furthest to the right.
std::optional<double> right_of(const std::vector<QPointF>& outline, QPointF centre) {
  std::optional<double> right;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const QPointF a = outline[i] - centre, b = outline[(i + 1) % outline.size()] - centre;
    if ((a.y() > 0) == (b.y() > 0)) continue;
    const double u = a.x() + (b.x() - a.x()) * a.y() / (a.y() - b.y());
    if (!right || u > *right) right = u;
  }
  if (!right || *right <= 0) return std::nullopt;
  return centre.x() + *right;
}

bool is_before_camera(const ShownBall& ball, const Eigen::Vector3d& centre_mm) {
  const double far = ball.camera.is_perspective() ? centre_mm.norm() : centre_mm.z();
  return centre_mm.allFinite() && centre_mm.z() > 0 && far > 1.02 * ball.radius_mm &&
         ball.camera.project(centre_mm).has_value();
}

}  // namespace

std::optional<ImageOutline> image_outline(const ShownBall& ball) {
  const auto centre = ball.camera.project(ball.centre_mm);
  if (!centre) return std::nullopt;
  const auto right = right_of(outline_of(ball, kMeasuredPoints), to_point(*centre));
  if (!right) return std::nullopt;
  return ImageOutline{to_point(*centre), *right};
}

std::optional<Eigen::Vector3d> ball_moved_to(const ShownBall& ball, QPointF pixel) {
  const auto ray = ball.camera.unproject({pixel.x(), pixel.y()});
  if (!ray) return std::nullopt;
  const double ahead = ball.normal.dot(ray->direction);
  if (!(ahead > kSlanted * ray->direction.norm())) return std::nullopt;
  const Eigen::Vector3d centre =
      ray->point_at(ball.normal.dot(ball.centre_mm - ray->origin_mm) / ahead);
  if (!is_before_camera(ball, centre)) return std::nullopt;
  return centre;
}

std::optional<Eigen::Vector3d> ball_with_rim_at(const ShownBall& ball, QPointF pixel) {
  const auto seen = ball.camera.project(ball.centre_mm);
  if (!seen || distance(to_point(*seen), pixel) < kMinOutline_px) return std::nullopt;
  const auto middle = ball.camera.unproject(*seen);
  const auto rim = ball.camera.unproject({pixel.x(), pixel.y()});
  if (!middle || !rim) return std::nullopt;
  // The rim's ray touches the ball: |(c(z) - o) x d| = R |d|, a quadratic equation in z.
  const Eigen::Vector3d& d = rim->direction;
  const Eigen::Vector3d fixed = (middle->origin_mm - rim->origin_mm).cross(d);
  const Eigen::Vector3d by_z = middle->direction.cross(d);
  const double a = by_z.squaredNorm(), b = fixed.dot(by_z);
  const double c = fixed.squaredNorm() - ball.radius_mm * ball.radius_mm * d.squaredNorm();
  const double inside = b * b - a * c;
  if (!(a > 0) || !(inside >= 0)) return std::nullopt;
  std::optional<Eigen::Vector3d> best;
  for (const double sign : {-1.0, 1.0}) {
    const Eigen::Vector3d centre = middle->point_at((-b + sign * std::sqrt(inside)) / a);
    const double change = std::abs(centre.z() - ball.centre_mm.z());
    if (is_before_camera(ball, centre) &&
        (!best || change < std::abs(best->z() - ball.centre_mm.z())))
      best = centre;
  }
  return best;
}

OutlineEditor::OutlineEditor(QWidget* parent) : ImageView(parent) {
  end_magnifying_.setSingleShot(true);
  end_magnifying_.setInterval(kOneRun_ms);
  connect(&end_magnifying_, &QTimer::timeout, this, [this] {
    magnified_.reset();
    update();
  });
  say([this] {
    setAccessibleName(tr("Image with the ball's outline"));
    setWhatsThis(
        tr("Drag the outline's centre or rim onto the ball. Arrow keys move it by a tenth of a "
           "pixel, Page Up and Page Down change its size, with Shift by one pixel. Ctrl and the "
           "arrow keys move the image; the wheel zooms, over the rim it changes the size."));
    announce();
  });
}

void OutlineEditor::set_ball(std::optional<ShownBall> ball) {
  ball_ = std::move(ball);
  outline_ = ball_ ? outline_of(*ball_, kDrawnPoints) : std::vector<QPointF>();
  image_outline_ = ball_ ? image_outline(*ball_) : std::nullopt;
  if (!image_outline_) {
    held_ = Part::kNone;
    magnified_.reset();
  }
  announce();
  update();
}

void OutlineEditor::announce() {
  const QLocale locale;
  QString text;
  if (image_outline_)
    text = tr("Centre u %1 px, v %2 px, radius %3 px; ball at x %4, y %5, z %6 mm")
               .arg(locale.toString(image_outline_->centre.x(), 'f', 1),
                    locale.toString(image_outline_->centre.y(), 'f', 1),
                    locale.toString(image_outline_->radius_px(), 'f', 1),
                    locale.toString(ball_->centre_mm.x(), 'f', 2),
                    locale.toString(ball_->centre_mm.y(), 'f', 2),
                    locale.toString(ball_->centre_mm.z(), 'f', 2));
  set_accessible_value(*this, text);
}

QPointF OutlineEditor::nearest_rim(QPointF widget) const {
  QPointF nearest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline_.size(); ++i) {
    const QPointF a = transform().to_widget(outline_[i]);
    const QPointF along = transform().to_widget(outline_[(i + 1) % outline_.size()]) - a;
    const double length2 = QPointF::dotProduct(along, along);
    const double part =
        length2 > 0 ? std::clamp(QPointF::dotProduct(widget - a, along) / length2, 0.0, 1.0) : 0;
    const QPointF here = a + part * along;
    if (distance(here, widget) < least) {
      least = distance(here, widget);
      nearest = here;
    }
  }
  return nearest;
}

OutlineEditor::Part OutlineEditor::part_at(QPointF widget) const {
  if (!image_outline_ || image().empty()) return Part::kNone;
  const double to_centre = distance(transform().to_widget(image_outline_->centre), widget);
  const double to_rim = distance(nearest_rim(widget), widget);
  if (std::min(to_centre, to_rim) > kReach) return Part::kNone;
  return to_rim < to_centre ? Part::kRim : Part::kCentre;
}

void OutlineEditor::begin_grip() {
  ++grip_;
  since_step_.invalidate();
}

void OutlineEditor::begin_step() {
  if (!since_step_.isValid() || since_step_.elapsed() > kOneRun_ms) ++grip_;
  since_step_.start();
  end_magnifying_.start();
}

void OutlineEditor::move_to(const std::optional<Eigen::Vector3d>& centre_mm) {
  if (!centre_mm || *centre_mm == ball_->centre_mm) return;
  const Eigen::Vector3d before = ball_->centre_mm;
  ShownBall moved = *ball_;
  moved.centre_mm = *centre_mm;
  moved.is_by_hand = true;
  if (!image_outline(moved)) return;
  set_ball(std::move(moved));
  Q_EMIT ball_moved(before, *centre_mm, grip_);
}

void OutlineEditor::move_by(QPointF px) {
  begin_step();
  move_to(ball_moved_to(*ball_, image_outline_->centre + px));
  magnify(image_outline_->centre);
}

void OutlineEditor::grow_by(double px) {
  begin_step();
  move_to(ball_with_rim_at(*ball_, {image_outline_->right_u + px, image_outline_->centre.y()}));
  magnify({image_outline_->right_u, image_outline_->centre.y()});
}

void OutlineEditor::magnify(QPointF point) {
  magnified_ = point;
  update();
}

QRectF OutlineEditor::magnifier() const {
  if (!magnified_ || !image_outline_) return {};
  const QPointF spot = transform().to_widget(*magnified_);
  QRectF ball(spot, QSizeF(1, 1));
  for (const QPointF& p : outline_) {
    const QPointF at = transform().to_widget(p);
    ball = ball.united(QRectF(at, QSizeF(1, 1)));
  }
  const QRectF room = QRectF(rect()).adjusted(6, 6, -6, -6);
  const QRectF ball_area =
      ball.intersected(room).adjusted(-kLoupeGap, -kLoupeGap, kLoupeGap, kLoupeGap);
  // Next to the full ball where there is room; else next to the hand; else in the corner furthest
  // from it.
  const auto fits = [&](const QRectF& loupe, const QRectF& hidden) {
    return room.contains(loupe) && !loupe.intersects(hidden);
  };
  const QRectF hand = QRectF(spot, QSizeF()).adjusted(-kLoupeGap, -kLoupeGap, kLoupeGap, kLoupeGap);
  for (const QRectF& hidden : {ball_area, hand}) {
    const double y = std::clamp(spot.y() - kLoupe / 2, room.top(), room.bottom() - kLoupe);
    const double x = std::clamp(spot.x() - kLoupe / 2, room.left(), room.right() - kLoupe);
    for (const QPointF corner :
         {QPointF(hidden.right() + 1, y), QPointF(hidden.left() - kLoupe - 1, y),
          QPointF(x, hidden.top() - kLoupe - 1), QPointF(x, hidden.bottom() + 1)}) {
      const QRectF loupe(corner, QSizeF(kLoupe, kLoupe));
      if (fits(loupe, hidden)) return loupe;
    }
  }
  const bool is_left = spot.x() > room.center().x(), is_up = spot.y() > room.center().y();
  return {is_left ? room.left() : room.right() - kLoupe,
          is_up ? room.top() : room.bottom() - kLoupe, kLoupe, kLoupe};
}

void OutlineEditor::paint_outline(QPainter& painter, const ImageTransform& transform,
                                  bool with_handles) const {
  QPolygonF polygon;
  for (const QPointF& p : outline_) polygon << transform.to_widget(p);
  QPainterPath path;
  path.addPolygon(polygon);
  path.closeSubpath();
  stroke_over(painter, path, kOutline, 1.6, ball_->is_by_hand ? Qt::SolidLine : Qt::DashLine);
  QPainterPath cross;
  const QPointF centre = transform.to_widget(image_outline_->centre);
  for (const QPointF arm : {QPointF(7, 0), QPointF(0, 7)}) {
    cross.moveTo(centre - arm);
    cross.lineTo(centre + arm);
  }
  stroke_over(painter, cross, kOutline, 1.6);
  if (!with_handles) return;
  const std::size_t quarter = outline_.size() / 4;
  for (std::size_t i = 0; quarter > 0 && i < 4; ++i) {
    const QPointF at = transform.to_widget(outline_[i * quarter]);
    painter.setPen(QPen(QColor(0, 0, 0, 190), 1.5));
    painter.setBrush(kOutline);
    painter.drawRect(QRectF(at - QPointF(3.5, 3.5), QSizeF(7, 7)));
  }
}

void OutlineEditor::paint_magnifier(QPainter& painter) const {
  const QRectF loupe = magnifier();
  const cv::Mat& grey = image();
  ImageTransform closer;
  closer.scale = std::max(kLoupeScale, 4 * transform().scale);
  closer.offset = loupe.center() - (*magnified_ + QPointF(0.5, 0.5)) * closer.scale;
  painter.save();
  QPainterPath clip;
  clip.addRoundedRect(loupe, 6, 6);
  painter.setClipPath(clip);
  painter.fillPath(clip, palette().window());
  const QImage source = grey_image(grey);
  // Only the visible pixels: scaling them all would cost more than everything else.
  const QRect shown = QRectF(closer.to_image(loupe.topLeft()), closer.to_image(loupe.bottomRight()))
                          .toAlignedRect()
                          .adjusted(-1, -1, 1, 1)
                          .intersected(source.rect());
  painter.setRenderHint(QPainter::SmoothPixmapTransform, false);
  const QRectF target(closer.to_widget(QPointF(shown.topLeft()) - QPointF(0.5, 0.5)),
                      QSizeF(shown.size()) * closer.scale);
  painter.drawImage(target, source, shown);
  paint_outline(painter, closer, false);
  painter.restore();
  painter.setBrush(Qt::NoBrush);
  painter.setPen(QPen(QColor(0, 0, 0, 190), 4));
  painter.drawRoundedRect(loupe, 6, 6);
  painter.setPen(QPen(Qt::white, 1.5));
  painter.drawRoundedRect(loupe, 6, 6);
}

void OutlineEditor::paintEvent(QPaintEvent* event) {
  ImageView::paintEvent(event);
  if (!image_outline_ || image().empty()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  paint_outline(painter, transform(), true);
  if (magnified_) paint_magnifier(painter);
}

void OutlineEditor::wheelEvent(QWheelEvent* event) {
  // With Shift the wheel turns sideways.
  const QPoint turn = event->angleDelta();
  const double notches = (turn.y() != 0 ? turn.y() : turn.x()) / 120.0;
  const bool is_on_rim = held_ != Part::kNone || part_at(event->position()) == Part::kRim;
  if (!is_on_rim || notches == 0) return ImageView::wheelEvent(event);
  const bool is_coarse = event->modifiers().testFlag(Qt::ShiftModifier);
  grow_by(notches * (is_coarse ? kCoarseStep_px : kFineStep_px));
}

void OutlineEditor::mousePressEvent(QMouseEvent* event) {
  const Part part = event->button() == Qt::LeftButton ? part_at(event->position()) : Part::kNone;
  if (part == Part::kNone) return ImageView::mousePressEvent(event);
  held_ = part;
  begin_grip();
  end_magnifying_.stop();
  const QPointF hand = transform().to_image(event->position());
  const QPointF from = part == Part::kCentre ? image_outline_->centre
                                             : transform().to_image(nearest_rim(event->position()));
  held_offset_ = hand - from;
  magnify(from);
}

void OutlineEditor::mouseMoveEvent(QMouseEvent* event) {
  if (held_ == Part::kNone) {
    const Part part = event->buttons() == Qt::NoButton ? part_at(event->position()) : Part::kNone;
    if (event->buttons() == Qt::NoButton) {
      if (part == Part::kNone)
        unsetCursor();
      else
        setCursor(part == Part::kCentre ? Qt::SizeAllCursor : Qt::SizeFDiagCursor);
    }
    return ImageView::mouseMoveEvent(event);
  }
  const QPointF target_px = transform().to_image(event->position()) - held_offset_;
  move_to(held_ == Part::kCentre ? ball_moved_to(*ball_, target_px)
                                 : ball_with_rim_at(*ball_, target_px));
  magnify(held_ == Part::kCentre ? image_outline_->centre : target_px);
}

void OutlineEditor::mouseReleaseEvent(QMouseEvent* event) {
  if (held_ == Part::kNone) return ImageView::mouseReleaseEvent(event);
  held_ = Part::kNone;
  magnified_.reset();
  unsetCursor();
  update();
}

void OutlineEditor::mouseDoubleClickEvent(QMouseEvent* event) {
  if (part_at(event->position()) == Part::kNone) ImageView::mouseDoubleClickEvent(event);
}

void OutlineEditor::keyPressEvent(QKeyEvent* event) {
  const bool pans = event->modifiers().testFlag(Qt::ControlModifier);
  if (!image_outline_ || image().empty() || pans) return ImageView::keyPressEvent(event);
  const double step =
      event->modifiers().testFlag(Qt::ShiftModifier) ? kCoarseStep_px : kFineStep_px;
  switch (event->key()) {
    case Qt::Key_Left:
      return move_by({-step, 0});
    case Qt::Key_Right:
      return move_by({step, 0});
    case Qt::Key_Up:
      return move_by({0, -step});
    case Qt::Key_Down:
      return move_by({0, step});
    case Qt::Key_PageUp:
      return grow_by(step);
    case Qt::Key_PageDown:
      return grow_by(-step);
    default:
      return ImageView::keyPressEvent(event);
  }
}

}  // namespace alltact
