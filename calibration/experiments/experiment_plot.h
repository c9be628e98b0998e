// What an experiment shows as a plot or a map, as plain values: drawn in reports, written as JSON.
#pragma once

#include "core/message.h"

#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct ExperimentSeries {
  enum class Look {
    kDots = 1,
    kLine,   ///< with its points
    kPaper,  ///< what the paper measured: dashed, without points; or a bar
    kAim,    ///< dotted
    kBars,   ///< beside each other at x = 0, 1, ...
    kExact,  ///< where all points would lie without error: thin
  };
  Message name;
  Look look = Look::kDots;
  std::vector<double> x, y;
};

struct ExperimentPlot {
  Message caption;         ///< a phrase: what it shows
  Message x_axis, y_axis;  ///< with units
  std::vector<ExperimentSeries> series;
  std::vector<Message> categories;  ///< names of x = 0, 1, ...; empty: x is a number
  bool logarithmic_y = false;       ///< where ours and the paper's are of different order
};

/// Depths of a piece of the face as if it were flat: from base to tip along a row, from large y to
/// small down a column.
struct ExperimentMap {
  Message name;
  cv::Mat_<float> mm;  ///< NaN: not told
};

/// Maps of one piece of the face. All depths are shown in one scale and all differences in another.
struct ExperimentMaps {
  Message caption;
  std::vector<ExperimentMap> depths, differences;  ///< a difference belongs below its depth;
                                                   ///< that of the first, the truth, has none
  double mm_per_cell = 0.05;
  double top_mm = 1, difference_top_mm = 0.1;  ///< where the scales end
};

/// Bars beside each other. The paper's may be empty.
[[nodiscard]] ExperimentPlot compared_bars(const Message& caption,
                                           const Message& y_axis,
                                           std::vector<Message> categories,
                                           std::vector<double> ours,
                                           std::vector<double> paper);

/// A level from one place to another: what the paper measured, or an aim.
[[nodiscard]] ExperimentSeries level_line(
    const Message& name, ExperimentSeries::Look look, double y, double from_x, double to_x);

}  // namespace alltact
