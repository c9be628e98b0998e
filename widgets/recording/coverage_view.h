// Coverage of bending, as a plot and as text.
#pragma once

#include "calibration/reference/bend_coverage.h"
#include "widgets/translated.h"

#include <QWidget>

namespace alltact {

[[nodiscard]] QString bend_direction_text(BendDirection direction);

/// Bend and sway as a field with the poses so far and the present pose, twist as a bar below. A
/// tick or a ring at each direction marks it as reached or not; screen readers get a sentence.
class CoverageView : public Translated<QWidget> {
  Q_OBJECT
 public:
  explicit CoverageView(QWidget* parent = nullptr);
  void show_coverage(const BendState& coverage);

  [[nodiscard]] QSize sizeHint() const override { return {280, 330}; }
  [[nodiscard]] QSize minimumSizeHint() const override { return {240, 290}; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void describe();
  void paint_field(QPainter& painter, const QRectF& field) const;
  void paint_twist(QPainter& painter, const QRectF& bar) const;
  void paint_label(QPainter& painter, const QRectF& room, int flags, BendDirection direction) const;
  void paint_sign(QPainter& painter, QPointF centre, bool is_reached) const;

  BendState coverage_;
};

}  // namespace alltact
