// An image with the exact outline of a ball over it, which the user can move to the ball.
#pragma once

#include "core/camera/camera.h"
#include "widgets/image/image_view.h"

#include <QElapsedTimer>
#include <QTimer>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// A ball in the camera's frame, and the source of its outline.
struct ShownBall {
  Camera camera;
  double radius_mm = 0;       ///< > 0
  Eigen::Vector3d centre_mm;  ///< in front of the camera
  bool is_by_hand = false;    ///< drawn solid; else dashed: found by the program
  /// A sideways move stays in the plane with this normal: with a face's normal the press depth
  /// stays the same.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// The outline in the image, px.
struct ImageOutline {
  QPointF centre;      ///< the image of the ball's centre, which is not the outline's middle
  double right_u = 0;  ///< where the outline crosses the row of `centre` on its right
  [[nodiscard]] double radius_px() const { return right_u - centre.x(); }
};
/// nullopt where the camera does not see it.
[[nodiscard]] std::optional<ImageOutline> image_outline(const ShownBall& ball);

/// The same ball moved sideways, with the image of its centre at `pixel`.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_moved_to(const ShownBall& ball, QPointF pixel);
/// The same ball nearer or further along the ray of its centre, so that its outline passes through
/// `pixel`. nullopt where no distance does that: the ball would not lie in front of the camera, or
/// the rays are parallel.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_with_rim_at(const ShownBall& ball, QPointF pixel);

/// All of ImageView, and with a ball:
/// Mouse: dragging the centre moves it sideways, dragging the rim changes its size (its distance);
/// the wheel over the rim changes the size by a tenth of a pixel a notch, with Shift by one. A
/// magnifier next to the hand shows the moved part.
/// Keys: arrows move by a tenth of a pixel, Page Up and Page Down make the outline larger and
/// smaller by as much; with Shift by one pixel. Ctrl and arrows pan.
class OutlineEditor : public ImageView {
  Q_OBJECT
 public:
  explicit OutlineEditor(QWidget* parent = nullptr);

  /// nullopt: there is no ball, and all keys are ImageView's.
  void set_ball(std::optional<ShownBall> ball);
  [[nodiscard]] const std::optional<ShownBall>& ball() const { return ball_; }
  [[nodiscard]] bool is_magnifying() const { return magnified_.has_value(); }
  /// The magnifier in widget coordinates; empty while there is none.
  [[nodiscard]] QRectF magnifier() const;

 Q_SIGNALS:
  /// The user moved the ball; the editor shows it already. `grip` stays the same during one drag,
  /// or while keys follow each other within a second, so that these are one undo step.
  void ball_moved(const Eigen::Vector3d& before_mm, const Eigen::Vector3d& after_mm, int grip);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  enum class Part { kNone = 1, kCentre, kRim };
  [[nodiscard]] Part part_at(QPointF widget) const;
  [[nodiscard]] QPointF nearest_rim(QPointF widget) const;  // widget coordinates
  void move_to(const std::optional<Eigen::Vector3d>& centre_mm);
  void move_by(QPointF px);
  void grow_by(double px);
  void begin_grip();
  void begin_step();
  void magnify(QPointF point);
  void announce();
  void paint_outline(QPainter& painter, const ImageTransform& transform, bool with_handles) const;
  void paint_magnifier(QPainter& painter) const;

  std::optional<ShownBall> ball_;
  std::optional<ImageOutline> image_outline_;
  std::vector<QPointF> outline_;  // image coordinates
  Part held_ = Part::kNone;
  QPointF held_offset_;  // from the held point to the hand, in image coordinates
  int grip_ = 0;
  QElapsedTimer since_step_;
  std::optional<QPointF> magnified_;  // image coordinates
  QTimer end_magnifying_;
};

}  // namespace alltact
