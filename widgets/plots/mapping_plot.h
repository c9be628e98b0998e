// The mapping: every block of every contact, and the fitted curve.
#pragma once

#include "widgets/plots/plot.h"

#include <vector>

namespace alltact {

struct MappingPlotData {
  struct Point {
    double x = 0, depth_mm = 0;
    bool is_certain = true;  ///< false: near the rim, where the skin may have left the ball
    bool is_chosen = false;  ///< of the chosen press: drawn over the others
  };
  struct CurvePoint {
    double x = 0, depth_mm = 0, sd_mm = 0;
  };
  std::vector<Point> points;
  std::vector<CurvePoint> curve;  ///< ascending in x
  double x_max = 0;               ///< end of the calibrated range; 0: none
  bool is_small = false;          ///< no room for legend and notes
  QString chosen;                 ///< the chosen press' name, for the legend
  QString depth_axis;             ///< its label with unit; empty: "Press depth (mm)"
};

class MappingPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  void set_data(MappingPlotData data);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_band();
  void draw_points(bool certain, const QString& name);
  void draw_chosen();
  MappingPlotData data_;
};

}  // namespace alltact
