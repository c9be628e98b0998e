// The experiments one by one; the table of them is in experiments.cpp.
#pragma once

#include "calibration/experiments/experiments.h"

#include <algorithm>

namespace alltact {

[[nodiscard]] Result<ExperimentOutcome> run_localisation(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_pose(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_direction(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_least_touch(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_least_force(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_force(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_references(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_room_light(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_thread(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_usb_plug(const ExperimentBench& bench);
[[nodiscard]] Result<ExperimentOutcome> run_time(const ExperimentBench& bench);

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

/// No frame tells a figure.
[[nodiscard]] inline Error untold(const std::string& scene) {
  return {en::say("no frame tells what the experiment asks for"), scene, ""};
}

}  // namespace alltact
