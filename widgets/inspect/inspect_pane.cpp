#include "widgets/inspect/inspect_pane.h"

#include "widgets/accessible.h"
#include "widgets/inspect/face_places.h"
#include "widgets/inspect/height_map.h"
#include "widgets/inspect/shown_scene.h"
#include "widgets/picture/overlays.h"

#include <QCursor>
#include <QMouseEvent>
#include <QVBoxLayout>

namespace alltact {

InspectPane::InspectPane(PaneContent content, QWidget* parent)
    : Translated(parent),
      content_(content),
      title_(new QLabel),
      beside_(new QLabel(this)),
      stack_(new QStackedWidget),
      map_(new ImageView) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(title_);
  layout->addWidget(stack_, 1);
  title_->hide();
  title_->setWordWrap(true);
  beside_->hide();
  beside_->setAttribute(Qt::WA_TransparentForMouseEvents);
  beside_->setAutoFillBackground(true);
  beside_->setBackgroundRole(QPalette::ToolTipBase);
  beside_->setForegroundRole(QPalette::ToolTipText);
  beside_->setMargin(4);
  connect(map_, &ImageView::probe_changed, this, [this] {
    const auto probe = map_->probe();
    Q_EMIT pointed_at(probe ? std::optional<QPointF>(*probe) : std::nullopt);
  });
  stack_->addWidget(map_);
  map_->installEventFilter(this);
}

void InspectPane::make_face_pane() {
  if (face_ != nullptr || !VtkView::is_supported()) return;
  face_ = new FacePane;
  stack_->addWidget(face_);
  connect(face_, &FacePane::clicked, this, &InspectPane::clicked);
  connect(face_, &FacePane::pointed_at, this, &InspectPane::pointed_at);
  connect(face_, &FacePane::looked, this, &InspectPane::looked);
  connect(face_, &FacePane::turned, this, &InspectPane::turned);
  connect(face_, &FacePane::all_wanted, this, &InspectPane::all_wanted);
  face_->change().set_options(options_.scene);
  look();
}

void InspectPane::look() {
  face_->change().look_from(options_.standpoint);
  if (options_.look) face_->change().look_as(*options_.look);
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
      options.standpoint != options_.standpoint || options.look != options_.look;
  const bool draws_else = !(options.scene == options_.scene);
  options_ = options;
  if (face_ != nullptr && draws_else) face_->change().set_options(options.scene);
  if (face_ != nullptr && stands_elsewhere) look();
  show_all();
}

void InspectPane::show_frame(std::shared_ptr<const InspectedFrame> frame) {
  frame_ = std::move(frame);
  in_gripper_.reset();
  show_all();
}

void InspectPane::show_pair(const FingerPair& pair) {
  const auto frames = pair.frames();
  frame_ = frames->first;
  in_gripper_ =
      InGripper{frames->second,
                {*pair.place(false)->gripper_from_camera, *pair.place(true)->gripper_from_camera},
                pair.gap()};
  show_all();
}

void InspectPane::show_beside_pointer(const QString& text) {
  // The height map tells it by itself.
  beside_->setVisible(!text.isEmpty() && stack_->currentWidget() == face_);
  if (beside_->isHidden()) return;
  beside_->setText(text);
  beside_->adjustSize();
  constexpr int kAway = 18;
  const QPoint at = mapFromGlobal(QCursor::pos());
  const int right = at.x() + kAway, below = at.y() + kAway;
  beside_->move(right + beside_->width() < width() ? right : at.x() - kAway - beside_->width(),
                below + beside_->height() < height() ? below : at.y() - kAway - beside_->height());
  beside_->raise();
}

void InspectPane::show_message(const QString& message) {
  frame_.reset();
  in_gripper_.reset();
  message_ = message;
  show_all();
}

void InspectPane::show_all() {
  if (!isVisible()) return;
  const bool has_face = frame_ && (frame_->surface || frame_->bare) && !waits_for_other();
  if (options_.shown_as == ShownAs::k3d && has_face) make_face_pane();
  if (options_.shown_as == ShownAs::k3d && has_face && face_ != nullptr)
    show_3d();
  else
    show_map();
}

/// What is compared with has not been measured yet: ordinary depth under another title would
/// deceive.
bool InspectPane::waits_for_other() const {
  return frame_ && content_ != PaneContent::kFirst && !in_gripper_ && frame_->surface &&
         !frame_->other_surface;
}

void InspectPane::show_3d() {
  FaceScene& scene = face_->change();
  scene.set_gap(in_gripper_ ? in_gripper_->gap : std::nullopt);
  show_in(scene,
          *frame_,
          content_,
          in_gripper_ ? std::optional(OtherInGripper{in_gripper_->second, in_gripper_->places})
                      : std::nullopt);
  scene.set_marks(marks_of(*frame_, options_));
  stack_->setCurrentWidget(face_);
  face_->point_again();
}

void InspectPane::show_map() {
  stack_->setCurrentWidget(map_);
  beside_->hide();
  if (!frame_) return map_->show_message(message_);
  if (waits_for_other())
    return map_->show_message(frame_->other_problem || frame_->other
                                  ? tr("There is nothing to compare with in this frame.")
                                  : tr("It is being measured a second time, to be compared."));
  const bool is_difference = content_ == PaneContent::kDifference;
  const FrameResult& result =
      content_ == PaneContent::kSecond && frame_->other ? *frame_->other : frame_->result;
  std::vector<Overlay> overlays;
  if (result.depth) {
    const cv::Mat& value = is_difference ? frame_->difference_mm : result.depth->depth_mm;
    const ColourScale scale = is_difference ? difference_scale(options_.scene.difference_top_mm)
                                            : depth_scale(options_.scene.top_mm);
    overlays.push_back(layer_overlay(height_layer(value, scale)));
    const cv::Mat limits =
        content_ == PaneContent::kFirst ? frame_->limits : cv::Mat();  // of the frame's own depth
    if (!limits.empty()) overlays.push_back(layer_overlay(limits_layer(limits)));
    overlays.push_back(
        points_overlay(pixel_of(*frame_, options_.a), pixel_of(*frame_, options_.b)));
    overlays.push_back(
        colour_bar_overlay(scale,
                           is_difference ? tr("Difference, mm") : tr("Depth, mm"),
                           limits.empty() ? std::vector<LegendLine>() : limits_legend(limits)));
  }
  if (!result.depth && result.edges) overlays.push_back(edges_overlay(*result.edges));
  map_->show_picture(result.grey, std::move(overlays));
}

void InspectPane::look_like(const InspectPane& other) {
  if (face_ != nullptr && other.face_ != nullptr)
    face_->change().look_as(other.face_->scene().look());
}

QImage InspectPane::map_picture(double scale) const {
  QImage picture((QSizeF(map_->size()) * scale).toSize(), QImage::Format_RGB32);
  picture.setDevicePixelRatio(scale);
  map_->render(&picture);
  picture.setDevicePixelRatio(1);
  return picture.convertToFormat(QImage::Format_BGR888);
}

void InspectPane::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  show_all();
}

bool InspectPane::eventFilter(QObject* watched, QEvent* event) {
  constexpr double kStill = 3;
  if (event->type() == QEvent::MouseButtonPress)
    pressed_ = static_cast<QMouseEvent*>(event)->position();
  if (event->type() == QEvent::MouseButtonRelease && pressed_ && frame_) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if ((mouse->position() - *pressed_).manhattanLength() <= kStill)
      Q_EMIT clicked(
          map_->transform().to_picture(mouse->position()),
          mouse->button() == Qt::RightButton || mouse->modifiers().testFlag(Qt::ControlModifier));
    pressed_.reset();
  }
  return Translated::eventFilter(watched, event);
}

}  // namespace alltact
