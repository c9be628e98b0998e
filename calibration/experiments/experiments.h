// The source paper's experiments, each as a scene and a measurement against its ground truth,
// compared with the paper's figure from a real finger.
//
// SIMULATED AND REAL
// Figures of this program are simulated: the truth is known, without robot, gauge or ageing
// silicone, and with the scene's noise only. The paper's figures were measured on a real finger
// with all of these. A smaller simulated figure shows the method's share of the error, not that of
// a real finger.
#pragma once

#include "calibration/experiments/experiment_bench.h"
#include "core/base/message.h"
#include "core/base/result.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Plots and maps of an experiment as plain values: drawn in reports, written as JSON.

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
[[nodiscard]] ExperimentPlot compared_bars(const Message& caption, const Message& y_axis,
                                           std::vector<Message> categories,
                                           std::vector<double> simulated,
                                           std::vector<double> paper);

/// A horizontal level from one x to another: a value of the paper, or an aim.
[[nodiscard]] ExperimentSeries level_line(const Message& name, ExperimentSeries::Style style,
                                          double y, double from_x, double to_x);

/// One number that an experiment measures.
struct ExperimentFigure {
  Message what;
  std::string unit;  ///< "mm", "degrees", "%", "N", "ms"
  double simulated = 0;
  std::optional<double> paper;  ///< empty: the paper has none, or shows an image only
  std::optional<double> aim;    ///< limit for the simulated value; empty: none
  bool more_is_better = false;

  /// Of those with an aim.
  [[nodiscard]] bool reaches_aim() const {
    return !aim || (more_is_better ? simulated >= *aim : simulated <= *aim);
  }
};

struct ExperimentOutcome {
  std::vector<ExperimentFigure> figures;
  int frames = 0;                ///< that were measured
  std::vector<Message> remarks;  ///< explanations that a figure does not contain
  std::vector<ExperimentPlot> plots;
  std::vector<ExperimentMaps> maps;
};

struct Experiment {
  std::string name;                 ///< as it is requested: "localisation"
  Message measures;                 ///< a phrase
  std::vector<std::string> scenes;  ///< files of resources/scenes, without the ending
  /// Errors: those of the bench; no frame gives a value for a figure.
  Result<ExperimentOutcome> (*run)(const ExperimentBench& bench);
};

/// In the order of the paper.
[[nodiscard]] const std::vector<Experiment>& experiments();

/// An experiment that was made.
struct ExperimentDone {
  const Experiment* experiment = nullptr;
  ExperimentOutcome outcome;
  double seconds = 0;
};

/// The content of a report.
struct ExperimentReport {
  std::vector<ExperimentDone> done;
  std::uint64_t seed = 1;
  std::string date;  ///< as utc_now() writes it
  std::string program_version;
};

/// Introduction of a report.
[[nodiscard]] Message simulated_and_real();

/// Experiments by name, each once, in the order of experiments(); all for an empty list. Error: an
/// unknown name, with the most similar known one.
[[nodiscard]] Result<std::vector<const Experiment*>> experiments_named(
    const std::vector<std::string>& names);

// The single experiments; their table is in experiments.cpp.

[[nodiscard]] Result<ExperimentOutcome> run_localisation(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_pose(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_direction(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_min_contact(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_min_force(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_force(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_references(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_room_light(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_thread(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_usb_plug(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_markers(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_time(const ExperimentBench& bench);

/// Number of random fingers on which force and light of the room are measured.
inline constexpr int kFingerVariants = 2;

/// Errors of many frames.
struct ErrorSamples {
  double sum = 0, greatest = 0;
  int count = 0;
  void add(double error) {
    sum += error, ++count;
    greatest = std::max(greatest, error);
  }
  [[nodiscard]] double mean() const { return count > 0 ? sum / count : 0.0; }
};

/// Part of `count` in percent.
[[nodiscard]] inline double percent_of(int part, int count) {
  return count > 0 ? 100.0 * part / count : 0.0;
}

/// Distance along the face between a region's position and the deepest point of the true contact.
/// Both are on the pressed face, p_CF = p_LUF - (0, 0, d). The component along the normal is depth,
/// not position.
[[nodiscard]] inline double position_error_mm(const ContactRegion& region,
                                              const ContactTruth& contact) {
  const Eigen::Vector3d deepest_mm = contact.point_mm - Eigen::Vector3d(0, 0, contact.depth_mm);
  const Eigen::Vector3d off = region.position_mm - deepest_mm;
  return (off - off.dot(contact.direction) * contact.direction).norm();
}

/// Error: no frame gives a value for the figure.
[[nodiscard]] inline Error no_result(const std::string& scene) {
  return {en::say("no frame gives a value for the experiment"), scene, ""};
}

}  // namespace alltact
