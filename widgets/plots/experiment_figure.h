// A plot of an experiment: ours, and beside it what the paper measured.
#pragma once

#include "calibration/experiments/experiment_plot.h"
#include "widgets/plots/plot.h"

#include <QPointF>
#include <vector>

namespace alltact {

class ExperimentFigurePlot : public Plot {
  Q_OBJECT
 public:
  explicit ExperimentFigurePlot(QWidget* parent = nullptr);
  void set_plot(const ExperimentPlot& plot);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_bars(const ExperimentSeries& series, int which, int of);
  void draw_points(const ExperimentSeries& series, int which);
  void find_extent();
  void set_ranges();
  ExperimentPlot plot_;
  QPointF least_, most_;    // of all points
  double least_shown_ = 0;  // of y, where it is logarithmic
};

}  // namespace alltact
