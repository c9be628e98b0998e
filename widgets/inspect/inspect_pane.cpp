#include "widgets/inspect/inspect_pane.h"

#include "core/sensing/depth/depth_sd.h"
#include "widgets/controls/number_field.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/widget_base.h"

#include <QCursor>
#include <QFontMetricsF>
#include <QImage>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QVBoxLayout>
#include <algorithm>
#include <array>
#include <cmath>

namespace alltact {

InspectPane::InspectPane(PaneContent content, QWidget* parent)
    : Translated(parent),
      content_(content),
      title_(wrapped_label()),
      pointer_label_(new QLabel(this)),
      stack_(new QStackedWidget),
      map_(new ImageView(nullptr, CopyFigure::Menu::kByKeysOnly)) {
  auto* layout = without_margins(new QVBoxLayout(this));
  layout->addWidget(title_);
  layout->addWidget(stack_, 1);
  title_->hide();
  pointer_label_->hide();
  pointer_label_->setAttribute(Qt::WA_TransparentForMouseEvents);
  pointer_label_->setAutoFillBackground(true);
  pointer_label_->setBackgroundRole(QPalette::ToolTipBase);
  pointer_label_->setForegroundRole(QPalette::ToolTipText);
  pointer_label_->setMargin(4);
  connect(map_, &ImageView::probe_changed, this, [this] {
    const auto probe = map_->probe();
    Q_EMIT pointed_at(probe ? std::optional<QPointF>(*probe) : std::nullopt);
  });
  stack_->addWidget(map_);
  map_->installEventFilter(this);
  if (VtkView::is_supported()) make_face_pane();
}

void InspectPane::make_face_pane() {
  face_ = new FacePane;
  stack_->addWidget(face_);
  connect(face_, &FacePane::clicked, this, &InspectPane::clicked);
  connect(face_, &FacePane::pointed_at, this, &InspectPane::pointed_at);
  connect(face_, &FacePane::view_changed, this, &InspectPane::view_changed);
  connect(face_, &FacePane::view_settled, this, &InspectPane::view_settled);
  connect(face_, &FacePane::reset_requested, this, &InspectPane::reset_requested);
  face_->change().set_options(options_.scene);
  apply_look();
}

void InspectPane::apply_look() {
  face_->change().set_viewpoint(options_.viewpoint);
  if (options_.view_pose) face_->change().set_view_pose(*options_.view_pose);
}

void InspectPane::set_content(PaneContent content) {
  content_ = content;
  show_all();
}

void InspectPane::set_title(const QString& title) {
  title_->setText(title);
  title_->setVisible(!title.isEmpty());
}

void InspectPane::set_options(const InspectOptions& options) {
  const bool stands_elsewhere =
      options.viewpoint != options_.viewpoint || options.view_pose != options_.view_pose;
  const bool draws_else = !(options.scene == options_.scene);
  options_ = options;
  if (face_ != nullptr && draws_else) face_->change().set_options(options.scene);
  if (face_ != nullptr && stands_elsewhere) apply_look();
  show_all();
}

void InspectPane::show_frames(const FramePair& frames) {
  frames_ = frames;
  show_all();
}

void InspectPane::show_at_pointer(const QString& text) {
  // The height map has a label of its own.
  pointer_label_->setVisible(!text.isEmpty() && stack_->currentWidget() == face_);
  if (pointer_label_->isHidden()) return;
  pointer_label_->setText(text);
  pointer_label_->adjustSize();
  constexpr int kAway = 18;
  const QPoint at = mapFromGlobal(QCursor::pos());
  const int right = at.x() + kAway, below = at.y() + kAway;
  pointer_label_->move(
      right + pointer_label_->width() < width() ? right : at.x() - kAway - pointer_label_->width(),
      below + pointer_label_->height() < height() ? below
                                                  : at.y() - kAway - pointer_label_->height());
  pointer_label_->raise();
}

void InspectPane::show_message(const QString& message) {
  frames_ = {};
  message_ = message;
  show_all();
}

void InspectPane::show_all() {
  if (!isVisible()) return;
  const bool has_face =
      frames_.first && (frames_.first->surface || frames_.first->bare) && !waits_for_other();
  if (options_.shown_as == ShownAs::k3d && has_face && face_ != nullptr)
    show_3d();
  else
    show_map();
}

/// The compared measurement is not finished: the primary depth under its title would mislead.
bool InspectPane::waits_for_other() const {
  return frames_.first && content_ != PaneContent::kFirst && !frames_.second &&
         frames_.first->surface && !frames_.first->other_surface;
}

void InspectPane::show_3d() {
  was_3d_ = true;
  FaceScene& scene = face_->change();
  show_in(scene, frames_, content_);
  scene.set_marks(marks_of(*frames_.first, options_));
  stack_->setCurrentWidget(face_);
  face_->update_pointer();
}

void InspectPane::show_map() {
  stack_->setCurrentWidget(map_);
  pointer_label_->hide();
  if (!frames_.first) return map_->show_message(message_);
  if (waits_for_other())
    return map_->show_message(frames_.first->other_problem || frames_.first->other
                                  ? tr("There is nothing to compare with in this frame.")
                                  : tr("The frame is being measured again for the comparison."));
  const bool is_difference = content_ == PaneContent::kDifference;
  const FrameResult& result = content_ == PaneContent::kSecond && frames_.first->other
                                  ? *frames_.first->other
                                  : frames_.first->result;
  std::vector<Overlay> overlays;
  if (result.depth) {
    const cv::Mat& value = is_difference ? frames_.first->difference_mm : result.depth->depth_mm;
    const ColourScale scale = is_difference ? difference_scale(options_.scene.difference_top_mm)
                                            : depth_scale(options_.scene.top_mm);
    overlays.push_back(layer_overlay(height_layer(value, scale)));
    const cv::Mat limits =
        // Limits apply to the frame's own depth.
        content_ == PaneContent::kFirst ? frames_.first->limits : cv::Mat();
    if (!limits.empty()) overlays.push_back(layer_overlay(limits_layer(limits)));
    overlays.push_back(
        points_overlay(pixel_of(*frames_.first, options_.a), pixel_of(*frames_.first, options_.b)));
    overlays.push_back(
        colour_bar_overlay(scale,
                           !is_difference               ? tr("Depth, mm")
                           : frames_.first->body_rms_mm ? tr("Distance, mm")
                                                        : tr("Difference, mm"),
                           limits.empty() ? std::vector<LegendLine>() : limits_legend(limits)));
  }
  if (!result.depth && result.edges) overlays.push_back(edges_overlay(*result.edges));
  map_->show_image(result.grey, std::move(overlays));
}

void InspectPane::copy_look(const InspectPane& other) {
  if (face_ != nullptr && other.face_ != nullptr)
    face_->change().set_view_pose(other.face_->scene().view_pose());
}

QImage InspectPane::map_image(double scale) const {
  QImage image((QSizeF(map_->size()) * scale).toSize(), QImage::Format_RGB32);
  image.setDevicePixelRatio(scale);
  map_->render(&image);
  image.setDevicePixelRatio(1);
  return image.convertToFormat(QImage::Format_BGR888);
}

void InspectPane::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  show_all();
}

bool InspectPane::eventFilter(QObject* watched, QEvent* event) {
  constexpr double kStill = 3;
  if (event->type() == QEvent::MouseButtonPress)
    pressed_ = static_cast<QMouseEvent*>(event)->position();
  if (event->type() == QEvent::MouseButtonRelease && pressed_ && frames_.first) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if ((mouse->position() - *pressed_).manhattanLength() <= kStill)
      Q_EMIT clicked(
          map_->transform().to_image(mouse->position()),
          mouse->button() == Qt::RightButton || mouse->modifiers().testFlag(Qt::ControlModifier));
    pressed_.reset();
  }
  return Translated::eventFilter(watched, event);
}

namespace {

constexpr double kTurn_deg = 5, kShift_part = 0.05, kCloser = 1.1;

cv::Vec3b colour_of(const QColor& colour) {
  return {static_cast<std::uint8_t>(colour.red()), static_cast<std::uint8_t>(colour.green()),
          static_cast<std::uint8_t>(colour.blue())};
}

}  // namespace

SceneColours scene_colours(const QPalette& palette) {
  return {colour_of(palette.color(QPalette::Base)), colour_of(palette.color(QPalette::Text)),
          window_decimal_mark() == DecimalMark::kComma ? ',' : '.'};
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
  connect(this, &FacePane::view_changed, this, [this] {
    scene_->set_moving(true);
    resting_.start();
  });
  connect(&pointing_, &QTimer::timeout, this,
          [this] { Q_EMIT pointed_at(pointer_ ? pixel_at(*pointer_) : std::nullopt); });
  new CopyFigure(
      *this, [this] { return can_draw() ? grabFramebuffer() : QImage(); },
      CopyFigure::Menu::kByKeysOnly);
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

void FacePane::update_pointer() {
  if (!pointing_.isActive()) pointing_.start();
}

void FacePane::apply_appearance() {
  change().set_colours(scene_colours(palette()));
  scene_->set_scale(devicePixelRatioF());
}

void FacePane::changeEvent(QEvent* event) {
  Translated::changeEvent(event);
  const bool is_other =
      event->type() == QEvent::PaletteChange || event->type() == QEvent::LanguageChange;
  if (is_other && scene_) apply_appearance();
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
  Q_EMIT clicked(*pixel, event->button() == Qt::RightButton ||
                             event->modifiers().testFlag(Qt::ControlModifier));
}

namespace {

const QColor kHalo(0, 0, 0, 190);
const QColor kMark(255, 184, 0);

constexpr int kPeriod = 12;  // px, of every pattern

struct Pattern {
  std::uint8_t limits;  // bits of DepthLimit
  cv::Vec4b bgra;       // premultiplied
  bool (*is_drawn)(int u, int v);
};
/// The first matching pattern is drawn.
const std::array<Pattern, 4> kPatterns{
    {{kDepthClamped, {255, 255, 255, 255}, [](int u, int v) { return (u + v) % 6 < 2; }},
     {kOutOfRange, {0, 0, 0, 255}, [](int u, int v) { return (u + 5 * v) % 6 < 2; }},
     {kDoubtfulLight,
      {60, 150, 255, 255},
      [](int u, int v) { return (u + 6) % 12 < 2 && (v + 6) % 12 < 2; }},
     {kSteep, {120, 120, 120, 120}, [](int u, int v) { return u % 6 == 3 && v % 6 == 3; }}}};

QString limit_text(std::uint8_t limits) {
  switch (limits) {
    case kDepthClamped:
      return InspectPane::tr("at the layer's limit");
    case kOutOfRange:
      return InspectPane::tr("beyond the calibrated range");
    case kDoubtfulLight:
      return InspectPane::tr("doubtful light");
    default:
      return InspectPane::tr("steep: position matters");
  }
}

void draw_point(QPainter& painter, QPointF at, const QString& letter) {
  constexpr double kRadius = 6;
  for (const auto& [colour, width] : {std::pair{kHalo, 4.5}, {kMark, 2.0}}) {
    painter.setPen(QPen(colour, width));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, kRadius, kRadius);
  }
  const QFontMetricsF metrics(painter.font());
  const QRectF label(at.x() + kRadius + 3, at.y() - 0.5 * metrics.height(),
                     metrics.horizontalAdvance(letter) + 6, metrics.height());
  painter.setPen(Qt::NoPen);
  painter.setBrush(kHalo);
  painter.drawRoundedRect(label, 3, 3);
  painter.setPen(kMark);
  painter.drawText(label, Qt::AlignCenter, letter);
}

}  // namespace

cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale) {
  const ColourTable colour_of(scale);
  cv::Mat layer(value_mm.size(), CV_8UC4);
  for (int v = 0; v < layer.rows; ++v) {
    const auto* value = value_mm.ptr<float>(v);
    auto* pixel = layer.ptr<cv::Vec4b>(v);
    for (int u = 0; u < layer.cols; ++u) {
      pixel[u] = cv::Vec4b(0, 0, 0, 0);
      if (!std::isfinite(value[u])) continue;
      const MapColour c = colour_of(value[u]);
      pixel[u] = cv::Vec4b(c.blue, c.green, c.red, 255);
    }
  }
  return layer;
}

cv::Mat limits_layer(const cv::Mat& limits) {
  cv::Mat layer = cv::Mat::zeros(limits.size(), CV_8UC4);
  bool is_empty = true;
  for (int v = 0; v < limits.rows; ++v) {
    const auto* bits = limits.ptr<std::uint8_t>(v);
    auto* pixel = layer.ptr<cv::Vec4b>(v);
    for (int u = 0; u < limits.cols; ++u)
      for (const Pattern& pattern : kPatterns)
        if ((bits[u] & pattern.limits) != 0 && pattern.is_drawn(u, v)) {
          pixel[u] = pattern.bgra;
          is_empty = false;
          break;
        }
  }
  return is_empty ? cv::Mat() : layer;
}

std::vector<LegendLine> limits_legend(const cv::Mat& limits) {
  constexpr int kMinPixels = 30;
  std::vector<LegendLine> legend;
  for (const Pattern& pattern : kPatterns) {
    int count = 0;
    for (int v = 0; v < limits.rows; ++v)
      count += static_cast<int>(
          std::count_if(limits.ptr<std::uint8_t>(v), limits.ptr<std::uint8_t>(v) + limits.cols,
                        [&](auto bits) { return (bits & pattern.limits) != 0; }));
    if (count < kMinPixels) continue;
    QImage tile(kPeriod, kPeriod, QImage::Format_ARGB32_Premultiplied);
    tile.fill(Qt::transparent);
    for (int v = 0; v < kPeriod; ++v)
      for (int u = 0; u < kPeriod; ++u)
        if (pattern.is_drawn(u, v))
          tile.setPixel(u, v,
                        qRgba(pattern.bgra[2], pattern.bgra[1], pattern.bgra[0], pattern.bgra[3]));
    legend.push_back({QBrush(tile), limit_text(pattern.limits)});
  }
  return legend;
}

Overlay points_overlay(const std::optional<cv::Point2d>& a, const std::optional<cv::Point2d>& b) {
  return [a, b](QPainter& painter, const ImageTransform& transform) {
    const auto widget_point = [&](const cv::Point2d& at) {
      return transform.to_widget({at.x, at.y});
    };
    if (a && b) {
      for (const auto& [colour, width] : {std::pair{kHalo, 4.5}, {kMark, 2.0}}) {
        painter.setPen(QPen(colour, width));
        painter.drawLine(widget_point(*a), widget_point(*b));
      }
      painter.setPen(QPen(kMark, 1.0, Qt::DashLine));  // the measured box
      painter.setBrush(Qt::NoBrush);
      painter.drawRect(QRectF(widget_point(*a), widget_point(*b)).normalized());
    }
    if (a) draw_point(painter, widget_point(*a), QStringLiteral("A"));
    if (b) draw_point(painter, widget_point(*b), QStringLiteral("B"));
  };
}

}  // namespace alltact
