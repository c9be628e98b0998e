#include "widgets/inspect/inspect_pane.h"

#include "widgets/accessible.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/face_positions.h"
#include "widgets/inspect/height_map.h"
#include "widgets/inspect/shown_scene.h"

#include <QCursor>
#include <QMouseEvent>
#include <QVBoxLayout>

namespace alltact {

InspectPane::InspectPane(PaneContent content, QWidget* parent)
    : Translated(parent),
      content_(content),
      title_(new QLabel),
      pointer_label_(new QLabel(this)),
      stack_(new QStackedWidget),
      map_(new ImageView) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(title_);
  layout->addWidget(stack_, 1);
  title_->hide();
  title_->setWordWrap(true);
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
}

void InspectPane::make_face_pane() {
  if (face_ != nullptr || !VtkView::is_supported()) return;
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
                {*pair.mount(false)->gripper_from_camera, *pair.mount(true)->gripper_from_camera},
                pair.gap()};
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

/// The compared measurement is not finished: the primary depth under its title would mislead.
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
          in_gripper_ ? std::optional(OtherInGripper{in_gripper_->second, in_gripper_->poses})
                      : std::nullopt);
  scene.set_marks(marks_of(*frame_, options_));
  stack_->setCurrentWidget(face_);
  face_->update_pointer();
}

void InspectPane::show_map() {
  stack_->setCurrentWidget(map_);
  pointer_label_->hide();
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
        // Limits apply to the frame's own depth.
        content_ == PaneContent::kFirst ? frame_->limits : cv::Mat();
    if (!limits.empty()) overlays.push_back(layer_overlay(limits_layer(limits)));
    overlays.push_back(
        points_overlay(pixel_of(*frame_, options_.a), pixel_of(*frame_, options_.b)));
    overlays.push_back(
        colour_bar_overlay(scale,
                           is_difference ? tr("Difference, mm") : tr("Depth, mm"),
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
  if (event->type() == QEvent::MouseButtonRelease && pressed_ && frame_) {
    const auto* mouse = static_cast<QMouseEvent*>(event);
    if ((mouse->position() - *pressed_).manhattanLength() <= kStill)
      Q_EMIT clicked(
          map_->transform().to_image(mouse->position()),
          mouse->button() == Qt::RightButton || mouse->modifiers().testFlag(Qt::ControlModifier));
    pressed_.reset();
  }
  return Translated::eventFilter(watched, event);
}

}  // namespace alltact
