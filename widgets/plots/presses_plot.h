// Depth error of a calibration over its number of presses.
#pragma once

#include "widgets/plots/plot.h"

#include <optional>
#include <vector>

namespace alltact {

struct PressesPoint {
  int presses = 0;
  double median_mm = 0, p95_mm = 0;
  std::optional<double> real_median_mm;  ///< of held-out presses, with another marker
  bool is_current = false;
};

/// A dot for the median, a whisker to 95 %; squares for the finger's own presses.
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
