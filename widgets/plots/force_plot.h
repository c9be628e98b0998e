// Forces of the last 30 s with their intervals, above the contacts in the same time.
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
  /// The reason why there is nothing to draw.
  void set_empty_text(const QString& text);
  /// Newtons at the lower and the upper end of the drawn axis.
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
