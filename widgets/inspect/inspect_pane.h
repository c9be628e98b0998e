// One measurement of a face, in 3D or as a height map, with a label at the pointer.
#pragma once

#include "core/image/colour_map.h"
#include "widgets/image/image_view.h"
#include "widgets/image/overlays.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/scene3d/face_scene.h"
#include "widgets/scene3d/vtk_view.h"
#include "widgets/widget_base.h"

#include <QLabel>
#include <QPointF>
#include <QStackedWidget>
#include <QTimer>
#include <memory>
#include <optional>
#include <vector>

namespace alltact {

// The face in 3D, controlled by mouse and keys.

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

/// The palette's colours for a scene, and the decimal mark of the window's language.
[[nodiscard]] SceneColours scene_colours(const QPalette& palette);

class InspectPane : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit InspectPane(PaneContent content, QWidget* parent = nullptr);

  void set_content(PaneContent content);
  void set_options(const InspectOptions& options);
  /// A joint pair: in 3D both fingers in the gripper's frame; as a height map the first.
  void show_frames(const FramePair& frames);
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
  [[nodiscard]] FacePane* face_pane() const { return was_3d_ ? face_ : nullptr; }
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

  PaneContent content_;
  InspectOptions options_;
  FramePair frames_;  // with a second one only in the gripper's frame
  QString message_;
  QLabel *title_, *pointer_label_;
  QStackedWidget* stack_;
  ImageView* map_;
  FacePane* face_ = nullptr;  // made at once: Qt makes a window anew for its first OpenGL
  bool was_3d_ = false;
  std::optional<QPointF> pressed_;
};

// A measured face as a colour-coded height map.

/// Values as colours, CV_8UC4 (premultiplied blue, green, red, alpha), transparent where there is
/// none.
[[nodiscard]] cv::Mat height_layer(const cv::Mat& value_mm, const ColourScale& scale);

/// Patterns where a depth is limited (DepthLimit bits, CV_8UC1), CV_8UC4 as above. White stripes:
/// at the layer's limit; black stripes: outside the calibrated range; orange dots: doubtful light;
/// small white dots: steep. Empty where no pixel is limited.
[[nodiscard]] cv::Mat limits_layer(const cv::Mat& limits);
/// Legend of the patterns that cover at least 30 pixels.
[[nodiscard]] std::vector<LegendLine> limits_legend(const cv::Mat& limits);

/// Points A and B with their letters, the line between them, and the box whose corners they are.
[[nodiscard]] Overlay points_overlay(const std::optional<cv::Point2d>& a,
                                     const std::optional<cv::Point2d>& b);

}  // namespace alltact
