// Plots and maps of an experiment as plain values: drawn in reports, written as JSON.
#pragma once

#include "core/message.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct ExperimentSeries {
  enum class Style {
    kDots = 1,
    kLine,   ///< with its points
    kPaper,  ///< measured by the paper: dashed, without points; or a bar
    kAim,    ///< dotted
    kBars,   ///< side by side at x = 0, 1, ...
    kExact,  ///< where all points would lie without error: thin
  };
  Message name;
  Style style = Style::kDots;
  std::vector<double> x, y;
};

struct ExperimentPlot {
  Message caption;         ///< a phrase: the content
  Message x_axis, y_axis;  ///< with units
  std::vector<ExperimentSeries> series;
  std::vector<Message> categories;  ///< names of x = 0, 1, ...; empty: x is a number
  /// where simulated and paper values differ by orders of magnitude
  bool logarithmic_y = false;
};

/// Depths of a piece of the face, flattened: from base to tip along a row, from large y to small
/// down a column.
struct ExperimentMap {
  Message name;
  cv::Mat_<float> mm;  ///< NaN: not measured
};

/// Maps of one piece of the face. All depths share one scale and all differences another.
struct ExperimentMaps {
  Message caption;
  /// each difference belongs to the depth of its index;
  std::vector<ExperimentMap> depths, differences;
  ///< the first depth, the ground truth, has none
  double mm_per_cell = 0.05;
  double top_mm = 1, difference_top_mm = 0.1;  ///< ends of the scales
};

/// Bars side by side. The paper's may be empty.
[[nodiscard]] ExperimentPlot compared_bars(const Message& caption,
                                           const Message& y_axis,
                                           std::vector<Message> categories,
                                           std::vector<double> simulated,
                                           std::vector<double> paper);

/// A horizontal level from one x to another: a value of the paper, or an aim.
[[nodiscard]] ExperimentSeries level_line(
    const Message& name, ExperimentSeries::Style style, double y, double from_x, double to_x);

}  // namespace alltact
