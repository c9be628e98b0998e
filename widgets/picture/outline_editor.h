// A picture with the exact outline of a ball over it, which a hand can put where the ball is seen.
#pragma once

#include "core/camera/camera.h"
#include "widgets/picture/image_view.h"

#include <QElapsedTimer>
#include <QTimer>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// A ball in the camera's frame, and how its outline came about.
struct ShownBall {
  Camera camera;
  double radius_mm = 0;       ///< > 0
  Eigen::Vector3d centre_mm;  ///< before the camera
  bool is_by_hand = false;    ///< drawn whole; else dashed: found by the program
  /// Moved sideways it stays in the plane at right angles to this: with a face's normal it stays
  /// pressed in as deep.
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
};

/// Where the outline is in the picture, px.
struct OutlinePlace {
  QPointF centre;      ///< the picture of the ball's centre, which is not the outline's middle
  double right_u = 0;  ///< where the outline crosses the row of `centre` on its right
  [[nodiscard]] double radius_px() const { return right_u - centre.x(); }
};
/// nullopt where the camera does not see it.
[[nodiscard]] std::optional<OutlinePlace> outline_place(const ShownBall& ball);

/// The same ball moved sideways, seen with its centre at `pixel`.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_moved_to(const ShownBall& ball, QPointF pixel);
/// The same ball nearer or further along the ray of its centre, so that its outline passes through
/// `pixel`. nullopt where no distance does that: beside the camera, or parallel rays.
[[nodiscard]] std::optional<Eigen::Vector3d> ball_with_rim_at(const ShownBall& ball, QPointF pixel);

/// Everything of ImageView, and where there is a ball:
/// Mouse: dragging the centre moves it sideways, dragging the rim changes its size (its distance);
/// the wheel over the rim changes the size by a tenth of a pixel a notch, with Shift by one. A
/// magnifier beside the hand shows what is being moved.
/// Keys: arrows move by a tenth of a pixel, Page Up and Page Down make the outline larger and
/// smaller by as much; with Shift by one pixel. Ctrl and arrows pan.
class OutlineEditor : public ImageView {
  Q_OBJECT
 public:
  explicit OutlineEditor(QWidget* parent = nullptr);

  /// Nothing: there is no ball, and all keys are ImageView's.
  void set_ball(std::optional<ShownBall> ball);
  [[nodiscard]] const std::optional<ShownBall>& ball() const { return ball_; }
  [[nodiscard]] bool is_magnifying() const { return magnified_.has_value(); }
  /// Where the magnifier lies, in widget coordinates; empty while there is none.
  [[nodiscard]] QRectF magnifier() const;

 Q_SIGNALS:
  /// A hand moved the ball: it is shown there already. `grip` stays the same during one drag, or
  /// while keys follow each other within a second, so that these can be undone in one step.
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
  void magnify(QPointF picture);
  void tell();
  void paint_outline(QPainter& painter, const ImageTransform& transform, bool with_handles) const;
  void paint_magnifier(QPainter& painter) const;

  std::optional<ShownBall> ball_;
  std::optional<OutlinePlace> place_;
  std::vector<QPointF> outline_;  // picture coordinates
  Part held_ = Part::kNone;
  QPointF held_offset_;  // from what is held to the hand, in picture coordinates
  int grip_ = 0;
  QElapsedTimer since_step_;
  std::optional<QPointF> magnified_;  // picture coordinates
  QTimer end_magnifying_;
};

}  // namespace alltact
