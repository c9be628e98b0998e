// The face in 3D, by mouse and by keys.
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
/// moves, the wheel comes closer; a click without dragging chooses a place, and without any button
/// the place under it is told. Keys: arrows turn,
/// Shift and arrows move, + and - come closer, 0 shows all.
class FacePane : public Translated<VtkView> {
  Q_OBJECT
 public:
  explicit FacePane(QWidget* parent = nullptr);
  ~FacePane() override;

  /// Something else may lie under the pointer now.
  void point_again();
  /// Draws soon after.
  [[nodiscard]] FaceScene& change();
  [[nodiscard]] const FaceScene& scene() const { return *scene_; }

 Q_SIGNALS:
  /// A pixel of the picture; is_second: with the right button, or Ctrl.
  void clicked(QPointF pixel, bool is_second);
  /// The pixel under the pointer; none: it is beside the face, or has left.
  void pointed_at(const std::optional<QPointF>& pixel);
  /// One looks from another place; also while a drag goes on.
  void looked();
  /// So one has come to look: at a drag's end, and at each step of the wheel or a key.
  void turned(bool is_drag);
  /// The key that shows all again.
  void all_wanted();

 protected:
  bool event(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;

 private:
  void dress();
  void begin_to_move();
  void tell_pointed_at();
  [[nodiscard]] std::optional<QPointF> pixel_at(QPointF place) const;
  std::unique_ptr<FaceScene> scene_;
  std::optional<QPointF> pointer_;  // where it is, without a button
  QTimer pointing_, resting_;
  struct Press {
    QPointF at;
    Look look;
  };
  std::optional<Press> pressed_;
};

/// The palette's colours for a scene.
[[nodiscard]] SceneColours scene_colours(const QPalette& palette);

}  // namespace alltact
