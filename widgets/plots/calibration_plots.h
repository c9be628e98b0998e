// The mapping: every block of every contact, and the fitted curve.
#pragma once

#include "calibration/joint/calibrate.h"
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
  [[nodiscard]] QString title() const override;
  [[nodiscard]] bool shows_title() const override { return !data_.is_small; }
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_band();
  void draw_points(bool certain, const QString& name);
  void draw_chosen();
  MappingPlotData data_;
};

// Convergence of a calibration, iteration by iteration.

/// Residual between presses and mapping (mm, left axis) and change of the unknowns (mm, right axis,
/// logarithmic). The iteration number continues where a new stage begins.
class ConvergencePlot : public Plot {
  Q_OBJECT
 public:
  explicit ConvergencePlot(QWidget* parent = nullptr);
  void set_rounds(const std::vector<Round>& rounds);

 protected:
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_residual();
  void draw_change();
  std::vector<Round> rounds_;
};

// Distribution of errors around zero.

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
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void add_line(double x, const QString& text, Qt::Alignment side);
  std::vector<double> errors_mm_;  // ascending
  double error_95_mm_ = 0;
  QString axis_;
};

// How much of a wave of the skin the measured depth retains.

/// The modulation transfer function of a finger.
class ContrastPlot : public Plot {
  Q_OBJECT
 public:
  using Plot::Plot;
  /// `contrasts`: DepthResolution::contrasts.
  void set_data(std::vector<double> contrasts);

 protected:
  bool draw() override;
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  std::vector<double> contrasts_;
};

// A finger's error over time, with the limits of its calibration.

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
  [[nodiscard]] QString title() const override;
  [[nodiscard]] QString empty_text() const override;

 private:
  void draw_band(double from_mm, double to_mm, QColor colour, const QString& word);
  HistoryData data_;
};

}  // namespace alltact
