#include "widgets/inspect/inspect_pane.h"

#include "core/sensing/measures.h"
#include "widgets/accessible.h"
#include "widgets/inspect/height_map.h"
#include "widgets/picture/overlays.h"

#include <QMouseEvent>
#include <QVBoxLayout>

namespace alltact {

InspectPane::InspectPane(PaneContent content, QWidget* parent)
    : Translated(parent),
      content_(content),
      title_(new QLabel),
      stack_(new QStackedWidget),
      map_(new ImageView) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(title_);
  layout->addWidget(stack_, 1);
  title_->hide();
  stack_->addWidget(map_);
  map_->installEventFilter(this);
}

void InspectPane::make_face_pane() {
  if (face_ != nullptr || !VtkView::is_supported()) return;
  face_ = new FacePane;
  stack_->addWidget(face_);
  connect(face_, &FacePane::clicked, this, &InspectPane::clicked);
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

void InspectPane::show_message(const QString& message) {
  frame_.reset();
  in_gripper_.reset();
  message_ = message;
  show_all();
}

void InspectPane::show_all() {
  if (!isVisible()) return;
  const bool has_face = frame_ && (frame_->surface || frame_->bare);
  if (options_.shown_as == ShownAs::k3d && has_face) make_face_pane();
  if (options_.shown_as == ShownAs::k3d && has_face && face_ != nullptr)
    show_3d();
  else
    show_map();
}

void InspectPane::show_3d() {
  FaceScene& scene = face_->change();
  const bool has_other = frame_->other_surface.has_value();
  scene.set_gap(in_gripper_ ? in_gripper_->gap : std::nullopt);
  if (frame_->bare)
    scene.show(*frame_->bare, *frame_->camera);
  else if (in_gripper_)
    scene.show_in_gripper(
        {*frame_->surface, *frame_->camera, in_gripper_->places[0]},
        {*in_gripper_->second->surface, *in_gripper_->second->camera, in_gripper_->places[1]});
  else if (content_ == PaneContent::kDifference && has_other)
    scene.show_difference(*frame_->surface, frame_->other_depth_mm, *frame_->camera);
  else if (content_ == PaneContent::kSecond && has_other)
    scene.show(*frame_->other_surface, *frame_->camera);
  else
    scene.show(*frame_->surface, *frame_->camera);
  SceneMarks marks;
  for (const auto& point : {options_.a, options_.b})
    if (point) marks.points.push_back(*point);
  if (options_.a && options_.b && frame_->surface)
    marks.lines.push_back(
        profile_between(frame_->result, frame_->face, {}, *options_.a, *options_.b).pixels);
  scene.set_marks(std::move(marks));
  stack_->setCurrentWidget(face_);
}

void InspectPane::show_map() {
  stack_->setCurrentWidget(map_);
  if (!frame_) return map_->show_message(message_);
  const bool is_difference = content_ == PaneContent::kDifference && frame_->other;
  const FrameResult& result =
      content_ == PaneContent::kSecond && frame_->other ? *frame_->other : frame_->result;
  std::vector<Overlay> overlays;
  if (result.depth && (!is_difference || frame_->other->depth)) {
    const cv::Mat value = is_difference ? depth_difference_mm(*frame_) : result.depth->depth_mm;
    const double top_mm = options_.scene.top_mm;
    const ColourScale scale = is_difference ? difference_scale(top_mm) : depth_scale(top_mm);
    overlays.push_back(layer_overlay(height_layer(value, scale)));
    overlays.push_back(points_overlay(options_.a, options_.b));
    overlays.push_back(
        colour_bar_overlay(scale, is_difference ? tr("Difference, mm") : tr("Depth, mm")));
  }
  if (!result.depth && result.edges) overlays.push_back(edges_overlay(*result.edges));
  map_->show_picture(result.grey, std::move(overlays));
}

void InspectPane::look_like(const InspectPane& other) {
  if (face_ != nullptr && other.face_ != nullptr)
    face_->change().look_as(other.face_->scene().look());
}

QImage InspectPane::picture() {
  if (stack_->currentWidget() == face_) return face_->grabFramebuffer();
  return map_->grab().toImage();
}

void InspectPane::showEvent(QShowEvent* event) {
  Translated::showEvent(event);
  show_all();
}

bool InspectPane::eventFilter(QObject* watched, QEvent* event) {
  constexpr double kStill = 3;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  if (event->type() == QEvent::MouseButtonPress) pressed_ = mouse->position();
  if (event->type() == QEvent::MouseButtonRelease && pressed_ && frame_) {
    if ((mouse->position() - *pressed_).manhattanLength() <= kStill)
      Q_EMIT clicked(
          map_->transform().to_picture(mouse->position()),
          mouse->button() == Qt::RightButton || mouse->modifiers().testFlag(Qt::ControlModifier));
    pressed_.reset();
  }
  return Translated::eventFilter(watched, event);
}

}  // namespace alltact
