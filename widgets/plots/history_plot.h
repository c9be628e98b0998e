// A finger's error over time, with the limits of its calibration.
#pragma once

#include "widgets/plots/plot.h"

#include <vector>

namespace alltact {

struct HistoryData {
  struct Point {
    double time_s = 0;  ///< since 1970, UTC
    double error_mm = 0;
  };
  std::vector<Point> points;     ///< in any order
  double drifting_above_mm = 0;  ///< a check passes below
  double recalibrate_above_mm = 0;
};

class HistoryPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  void set_data(HistoryData data);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_band(double from_mm, double to_mm, QColor colour, const QString& word);
  HistoryData data_;
};

}  // namespace alltact
