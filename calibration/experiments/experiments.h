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

}  // namespace alltact
