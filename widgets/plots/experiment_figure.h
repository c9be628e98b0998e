// A plot of an experiment: its measured values next to those of the paper.
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
  QPointF min_, max_;     // of all points
  double min_shown_ = 0;  // of y, where it is logarithmic
};

}  // namespace alltact
