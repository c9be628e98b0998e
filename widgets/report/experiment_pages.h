// The report of the paper's experiments: every measured figure next to the paper's.
#pragma once

#include "calibration/experiments/experiments.h"
#include "calibration/finger/calibrate_finger.h"
#include "core/base/result.h"
#include "widgets/plots/plot.h"

#include <QImage>
#include <QPointF>
#include <string>
#include <vector>

namespace alltact {

/// NAME.html and NAME.pdf; the same report gives the same bytes. Needs a QApplication, on any
/// platform, and its thread. Error: the printing failed.
[[nodiscard]] Result<std::vector<ReportFile>> make_experiment_pages(const ExperimentReport& report,
                                                                    const std::string& name);

// Depth maps next to each other, in colours with their scales.

/// Depth maps in a row; below each but the first, the truth, its difference from it. Below the
/// truth: the two scales in mm and a length of 5 mm. All depths share one scale of colours, all
/// differences another; grey where there is no value.
///   width: px at 96 to the inch, with `sharpness` pixels along each side of one
[[nodiscard]] QImage relief_image(const ExperimentMaps& maps, int width, double sharpness);

// A plot of an experiment: its measured values next to those of the paper.

class ExperimentFigurePlot : public Plot {
  Q_OBJECT
 public:
  explicit ExperimentFigurePlot(QWidget* parent = nullptr);
  void set_plot(const ExperimentPlot& plot);

 protected:
  bool draw() override;
  [[nodiscard]] bool shows_title() const override { return false; }
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
