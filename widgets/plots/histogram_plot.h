// Distribution of errors around zero.
#pragma once

#include "widgets/plots/plot.h"

#include <vector>

namespace alltact {

class HistogramPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// Signed errors in mm, positive where the mapping reads too deep; not finite values are left
  /// out. `axis`: label with the unit.
  void set_data(std::vector<double> errors_mm, const QString& axis);

  /// The 95 % quantile of the magnitude; 0 without errors.
  [[nodiscard]] double error_95_mm() const { return error_95_mm_; }

 protected:
  bool draw() override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void add_line(double x, const QString& text, Qt::Alignment side);
  std::vector<double> errors_mm_;  // ascending
  double error_95_mm_ = 0;
  QString axis_;
};

}  // namespace alltact
