// Convergence of a calibration, iteration by iteration.
#pragma once

#include "calibration/joint/round.h"
#include "widgets/plots/plot.h"

#include <vector>

namespace alltact {

/// Residual between presses and mapping (mm, left axis) and change of the unknowns (mm, right axis,
/// logarithmic). The iteration number continues where a new stage begins.
class ConvergencePlot : public Plot {
  Q_OBJECT
 public:
  explicit ConvergencePlot(QWidget* parent = nullptr);
  void set_rounds(const std::vector<Round>& rounds);

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_residual();
  void draw_change();
  std::vector<Round> rounds_;
};

}  // namespace alltact
