// Forces of the last half minute, with their intervals, over what touched meanwhile.
#pragma once

#include "widgets/plots/plot.h"
#include "widgets/touch/touch_history.h"

#include <optional>
#include <utility>

namespace alltact {

class ForcePlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  void set_data(const TouchHistory& history, const std::optional<ForceZero>& zero);
  /// Why there is nothing to draw.
  void set_empty_text(const QString& text);
  /// Newtons at the lower and the upper end, as they are drawn.
  [[nodiscard]] std::pair<double, double> span_N() const { return {low_N_, top_N_}; }

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override { return empty_text_; }

 private:
  void set_span();
  void draw_contacts();
  void draw_span(double from_s, double to_s, int alpha, Qt::BrushStyle style);
  void draw_axis(int axis);
  [[nodiscard]] QString axis_name(int axis) const;

  TouchHistory history_;
  std::optional<ForceZero> zero_;
  QString empty_text_;
  double low_N_ = 0, top_N_ = 0;
};

}  // namespace alltact
