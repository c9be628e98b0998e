// How a solution settles, round by round.
#pragma once

#include "calibration/joint/round.h"
#include "widgets/plots/plot.h"

#include <vector>

namespace alltact {

/// What is left between presses and mapping (mm, to the left), and how much the unknowns still move
/// (mm, in powers of ten to the right). Rounds count on where a new stretch begins.
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
