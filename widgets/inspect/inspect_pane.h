// One measurement of a face, in 3D or as a height map, with a label at the pointer.
#pragma once

#include "widgets/image/image_view.h"
#include "widgets/inspect/face_pane.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/translated.h"

#include <QLabel>
#include <QStackedWidget>
#include <memory>

namespace alltact {

class InspectPane : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit InspectPane(PaneContent content, QWidget* parent = nullptr);

  void set_content(PaneContent content);
  void set_options(const InspectOptions& options);
  void show_frame(std::shared_ptr<const InspectedFrame> frame);
  /// In 3D both fingers in the gripper's frame; as a height map the first.
  void show_pair(const FingerPair& pair);
  /// Text at the pointer while it is over the face; empty: none.
  void show_at_pointer(const QString& text);
  /// Instead of a frame: why there is none.
  void show_message(const QString& message);
  /// Shown above; empty: none.
  void set_title(const QString& title);
  void copy_look(const InspectPane& other);
  /// Whether the face or a message is shown in 3D; and the size of the view, logical pixels.
  [[nodiscard]] bool is_3d() const { return face_ != nullptr && stack_->currentWidget() == face_; }
  [[nodiscard]] QSize image_size() const { return stack_->size(); }
  /// The height map with `scale` times as many pixels, Format_BGR888.
  [[nodiscard]] QImage map_image(double scale) const;
  /// Null where there is no OpenGL, or before the pane was shown in 3D.
  [[nodiscard]] FacePane* face_pane() const { return face_; }
  [[nodiscard]] ImageView& height_map() const { return *map_; }

 Q_SIGNALS:
  void clicked(QPointF pixel, bool is_second);
  /// The pixel under the pointer; none: the pointer is outside the face.
  void pointed_at(const std::optional<QPointF>& pixel);
  void view_changed();
  void view_settled(bool is_drag);
  void reset_requested();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_face_pane();
  void show_all();
  void show_3d();
  void show_map();
  [[nodiscard]] bool waits_for_other() const;
  void apply_look();

  struct InGripper {
    std::shared_ptr<const InspectedFrame> second;
    std::array<RigidTransform, 2> poses;
    std::optional<NearestPoints> gap;
  };
  PaneContent content_;
  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  std::optional<InGripper> in_gripper_;
  QString message_;
  QLabel *title_, *pointer_label_;
  QStackedWidget* stack_;
  ImageView* map_;
  FacePane* face_ = nullptr;
  std::optional<QPointF> pressed_;
};

}  // namespace alltact
