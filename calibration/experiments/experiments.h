// The source paper's experiments, each as a scene and a measurement against its truth, beside the
// figure that the paper measured on a real finger.
//
// OURS AND THEIRS
// Ours are simulated: the truth is known, there is no robot, no gauge and no silicone that ages,
// and noise is that of the scene alone. Theirs were measured on a real finger with all of that in
// them. That ours are less says what the method adds to the error, not that a real finger would do
// so.
#pragma once

#include "calibration/experiments/experiment_bench.h"
#include "calibration/experiments/experiment_plot.h"
#include "core/message.h"
#include "core/result.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// One number that an experiment measures.
struct ExperimentFigure {
  Message what;
  std::string unit;  ///< "mm", "degrees", "%", "N", "ms"
  double ours = 0;
  std::optional<double> paper;  ///< absent: the paper tells none, or shows a picture
  std::optional<double> aim;    ///< what ours should reach; absent: none was set
  bool more_is_better = false;

  /// Of those with an aim.
  [[nodiscard]] bool reaches_aim() const {
    return !aim || (more_is_better ? ours >= *aim : ours <= *aim);
  }
};

struct ExperimentOutcome {
  std::vector<ExperimentFigure> figures;
  int frames = 0;                ///< that were measured
  std::vector<Message> remarks;  ///< what a figure does not say of itself
  std::vector<ExperimentPlot> plots;
  std::vector<ExperimentMaps> maps;
};

struct Experiment {
  std::string name;                 ///< as it is asked for: "localisation"
  Message measures;                 ///< a phrase
  std::vector<std::string> scenes;  ///< files of resources/scenes, without the ending
  /// Errors: those of the bench; a figure that no frame tells.
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

/// All that a report of them tells.
struct ExperimentReport {
  std::vector<ExperimentDone> done;
  std::uint64_t seed = 1;
  std::string date;  ///< as utc_now() writes it
  std::string program_version;
};

/// How a report begins.
[[nodiscard]] Message ours_and_theirs();

/// By their names; none: all. Each once, in the order of experiments(). Error: there is no such
/// experiment, with the name that is nearest.
[[nodiscard]] Result<std::vector<const Experiment*>> experiments_named(
    const std::vector<std::string>& names);

}  // namespace alltact
