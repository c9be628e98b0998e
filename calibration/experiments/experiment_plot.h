// What an experiment shows as a plot or a picture, as plain values: drawn in reports, written as
// JSON.
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
};

/// A picture in colours (CV_8UC3, blue, green, red).
struct ExperimentPicture {
  Message caption;
  cv::Mat colours;
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
