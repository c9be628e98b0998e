// The face in 3D, controlled by mouse and keys.
#pragma once

#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/translated.h"

#include <QPointF>
#include <QTimer>
#include <memory>
#include <optional>

namespace alltact {

/// Only where VtkView::is_supported(). Mouse: dragging turns, with Shift or the middle button it
/// pans, the wheel zooms. A click without dragging chooses a position; without a button the
/// position under the pointer is reported. Keys: arrows turn, Shift and arrows pan, + and - zoom, 0
/// shows all.
class FacePane : public Translated<VtkView> {
  Q_OBJECT
 public:
  explicit FacePane(QWidget* parent = nullptr);
  ~FacePane() override;

  /// Reports the position under the pointer again, since the scene may have changed.
  void update_pointer();
  /// The scene to be changed; it is drawn soon after.
  [[nodiscard]] FaceScene& change();
  [[nodiscard]] const FaceScene& scene() const { return *scene_; }

 Q_SIGNALS:
  /// A pixel of the image; is_second: with the right button, or Ctrl.
  void clicked(QPointF pixel, bool is_second);
  /// The pixel under the pointer; none: the pointer is outside the face.
  void pointed_at(const std::optional<QPointF>& pixel);
  /// The 3D camera has moved; also emitted during a drag.
  void view_changed();
  /// A movement has ended: at the end of a drag, and at each step of the wheel or a key.
  void view_settled(bool is_drag);
  /// The key that shows all.
  void reset_requested();

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void apply_appearance();
  void begin_motion();
  void report_pointed_at();
  [[nodiscard]] std::optional<QPointF> pixel_at(QPointF point) const;
  std::unique_ptr<FaceScene> scene_;
  std::optional<QPointF> pointer_;  // its position while no button is pressed
  QTimer pointing_, resting_;
  struct Press {
    QPointF at;
    ViewPose view_pose;
  };
  std::optional<Press> pressed_;
};

/// The palette's colours for a scene.
[[nodiscard]] SceneColours scene_colours(const QPalette& palette);

}  // namespace alltact
