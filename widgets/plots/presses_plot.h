// How close a calibration reads depth, by how many presses it has.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <vector>

namespace alltact {

struct PressesPoint {
  int presses = 0;
  double median_mm = 0, p95_mm = 0;
  std::optional<double> real_median_mm;  ///< of presses that were left out, marked apart
  bool is_now = false;
};

/// A dot for half of all points, a whisker to 95 %; squares where the finger's own presses tell.
class PressesPlot : public Plot {
  Q_OBJECT
 public:
  explicit PressesPlot(QWidget* parent = nullptr);
  /// Ascending by presses.
  void set_points(std::vector<PressesPoint> points);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<PressesPoint> points_;
};

}  // namespace alltact
