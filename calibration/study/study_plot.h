// A plot of cost against benefit, as SVG: dots, whiskers, a staircase, a few names.
#pragma once

#include "calibration/study/accuracy_study.h"
#include "calibration/study/calibrating_study.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct PlotDot {
  double x = 0, y = 0;
  std::optional<double> y95;   ///< end of the whisker
  std::optional<double> real;  ///< the same measured with real presses: marked apart
  std::optional<double> real95;
  std::string words;         ///< label below the plot where the dot is named
  bool is_on_front = false;  ///< else grey
  bool is_base = false;      ///< ringed, and always named
};

struct StudyPlot {
  std::string title, subtitle, x_label, y_label;
  std::string real_label;        ///< of the real marks; empty: there are none
  std::vector<PlotDot> dots;     ///< at least one; x and y finite and not negative
  bool has_staircase = true;     ///< along the front's running minimum
  std::optional<double> budget;  ///< a line at this x, or an arrow where it lies outside
  std::string budget_words;
  /// in the order of preference; those that lie apart, up to seven, get a number and a line below
  std::vector<std::size_t> named;
};

/// SVG, 900 px wide and as high as its names need. Both axes are linear from 0. Dots far outside
/// the front and the base are counted, not drawn.
[[nodiscard]] std::string svg_of(const StudyPlot& plot);

// Plots of studies.

/// SVG (study_plot.h): depth error over frame time, both linear from 0. The front is a staircase: a
/// dot for the median, a whisker for 95 %, names below (seven at most, the base always). Presses
/// left out have their own marks; dominated rows are grey. A line marks 33.3 ms (30 frames a
/// second), an arrow where it lies outside.
[[nodiscard]] std::string svg_of(const AccuracyStudy& study);

/// The same for a calibration, over the total minutes of technician and computer.
[[nodiscard]] std::string svg_of(const CalibratingStudy& study);

}  // namespace alltact
