// One measurement of a face, in 3D or as a height map, with what lies under the pointer beside it.
#pragma once

#include "widgets/inspect/face_pane.h"
#include "widgets/inspect/finger_pair.h"
#include "widgets/inspect/inspect_options.h"
#include "widgets/picture/image_view.h"
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
  /// Beside the pointer, as long as it is over the face; empty: nothing.
  void show_beside_pointer(const QString& text);
  /// Instead of a frame: why there is none.
  void show_message(const QString& message);
  /// Shown above; empty: none.
  void set_title(const QString& title);
  void look_like(const InspectPane& other);
  /// The face, or a message, is shown in 3D, and how large, in logical pixels.
  [[nodiscard]] bool is_3d() const { return face_ != nullptr && stack_->currentWidget() == face_; }
  [[nodiscard]] QSize picture_size() const { return stack_->size(); }
  /// The height map with `scale` times as many pixels, Format_BGR888.
  [[nodiscard]] QImage map_picture(double scale) const;
  /// Null where there is no OpenGL, or before the pane was shown in 3D.
  [[nodiscard]] FacePane* face_pane() const { return face_; }
  [[nodiscard]] ImageView& height_map() const { return *map_; }

 Q_SIGNALS:
  void clicked(QPointF pixel, bool is_second);
  /// The pixel under the pointer; none: it is beside the face.
  void pointed_at(const std::optional<QPointF>& pixel);
  void looked();
  void turned(bool is_drag);
  void all_wanted();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;

 private:
  void make_face_pane();
  void show_all();
  void show_3d();
  void show_map();
  [[nodiscard]] bool waits_for_other() const;
  void look();

  struct InGripper {
    std::shared_ptr<const InspectedFrame> second;
    std::array<RigidTransform, 2> places;
    std::optional<NearestPoints> gap;
  };
  PaneContent content_;
  InspectOptions options_;
  std::shared_ptr<const InspectedFrame> frame_;
  std::optional<InGripper> in_gripper_;
  QString message_;
  QLabel *title_, *beside_;
  QStackedWidget* stack_;
  ImageView* map_;
  FacePane* face_ = nullptr;
  std::optional<QPointF> pressed_;
};

}  // namespace alltact
