#include "widgets/inspect/face_pane.h"

#include "widgets/accessible.h"

#include <QKeyEvent>
#include <QMouseEvent>

namespace alltact {
namespace {

constexpr double kTurn_deg = 5, kShift_part = 0.05, kCloser = 1.1;

cv::Vec3b colour_of(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()),
          static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

}  // namespace

SceneColours scene_colours(const QPalette& palette) {
  return {colour_of(palette.color(QPalette::Base)), colour_of(palette.color(QPalette::Text))};
}

FacePane::FacePane(QWidget* parent)
    : Translated(parent), scene_(std::make_unique<FaceScene>(scene_window())) {
  set_accessible_role(*this, QAccessible::Graphic);
  apply_appearance();
  constexpr int kPointerInterval_ms = 25;
  pointing_.setSingleShot(true);
  pointing_.setInterval(kPointerInterval_ms);
  constexpr int kRestDelay_ms = 250;
  resting_.setSingleShot(true);
  resting_.setInterval(kRestDelay_ms);
  connect(&resting_, &QTimer::timeout, this, [this] {
    if (scene_->set_moving(false)) draw_later();
  });
  connect(this, &FacePane::view_changed, this, &FacePane::begin_motion);
  connect(&pointing_, &QTimer::timeout, this, &FacePane::report_pointed_at);
  say([this] { setAccessibleName(tr("Face in 3D")); });
}

FacePane::~FacePane() = default;

FaceScene& FacePane::change() {
  draw_later();
  return *scene_;
}

std::optional<QPointF> FacePane::pixel_at(QPointF point) const {
  const double ratio = devicePixelRatioF();
  const auto pixel = scene_->pixel_at(point.x() * ratio, point.y() * ratio);
  return pixel ? std::optional(QPointF(pixel->x, pixel->y)) : std::nullopt;
}

void FacePane::begin_motion() {
  scene_->set_moving(true);
  resting_.start();
}

void FacePane::update_pointer() {
  if (!pointing_.isActive()) pointing_.start();
}

void FacePane::report_pointed_at() {
  Q_EMIT pointed_at(pointer_ ? pixel_at(*pointer_) : std::nullopt);
}

void FacePane::apply_appearance() {
  change().set_colours(scene_colours(palette()));
  scene_->set_scale(devicePixelRatioF());
}

void FacePane::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  if (event->type() == QEvent::PaletteChange && scene_) apply_appearance();
}

void FacePane::resizeEvent(QResizeEvent* event) {
  Translated::resizeEvent(event);
  apply_appearance();
  scene_->fit();
}

bool FacePane::event(QEvent* event) {
  const bool is_wheel = event->type() == QEvent::Wheel;
  const auto before = is_wheel ? std::optional(scene_->view_pose()) : std::nullopt;
  const bool is_taken = Translated::event(event);
  const auto* mouse =
      event->type() == QEvent::MouseMove ? static_cast<QMouseEvent*>(event) : nullptr;
  if (is_wheel || (mouse != nullptr && mouse->buttons() != Qt::NoButton)) Q_EMIT view_changed();
  if (mouse != nullptr || event->type() == QEvent::Leave || is_wheel) {
    const bool is_pointing = mouse != nullptr && mouse->buttons() == Qt::NoButton;
    if (!is_wheel) pointer_ = is_pointing ? std::optional(mouse->position()) : std::nullopt;
    update_pointer();
  }
  // A touchpad sends fractions of a step.
  if (is_wheel && !(scene_->view_pose() == *before)) Q_EMIT view_settled(false);
  return is_taken;
}

void FacePane::keyPressEvent(QKeyEvent* event) {
  const bool moves = event->modifiers().testFlag(Qt::ShiftModifier);
  const auto steer = [&](double right, double up) {
    if (moves)
      change().shift(right * kShift_part, up * kShift_part);
    else
      change().turn(-right * kTurn_deg, -up * kTurn_deg);
  };
  switch (event->key()) {
    case Qt::Key_Left:
      steer(-1, 0);
      break;
    case Qt::Key_Right:
      steer(1, 0);
      break;
    case Qt::Key_Up:
      steer(0, 1);
      break;
    case Qt::Key_Down:
      steer(0, -1);
      break;
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      change().dolly(kCloser);
      break;
    case Qt::Key_Minus:
      change().dolly(1 / kCloser);
      break;
    case Qt::Key_0:
      return Q_EMIT reset_requested();
    default:
      return Translated::keyPressEvent(event);
  }
  Q_EMIT view_changed();
  Q_EMIT view_settled(false);
}

void FacePane::mousePressEvent(QMouseEvent* event) {
  if (!pressed_) pressed_ = Press{event->position(), scene_->view_pose()};
}

void FacePane::mouseReleaseEvent(QMouseEvent* event) {
  constexpr double kStill = 3;  // logical pixels of movement that still count as a click
  if (!pressed_ || event->buttons() != Qt::NoButton) return;
  const Press press = *pressed_;
  pressed_.reset();
  const bool is_turned = !(scene_->view_pose() == press.view_pose);
  const bool is_click = (event->position() - press.at).manhattanLength() <= kStill;
  if (is_turned && is_click) {
    change().set_view_pose(press.view_pose);
    Q_EMIT view_changed();
  } else if (is_turned) {
    Q_EMIT view_settled(true);
  }
  if (!is_click || event->button() == Qt::MiddleButton) return;
  const auto pixel = pixel_at(event->position());
  if (!pixel) return;
  Q_EMIT clicked(
      *pixel,
      event->button() == Qt::RightButton || event->modifiers().testFlag(Qt::ControlModifier));
}

}  // namespace alltact
