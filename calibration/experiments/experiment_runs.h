// The single experiments; their table is in experiments.cpp.
#pragma once

#include "calibration/experiments/experiments.h"

#include <algorithm>

namespace alltact {

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
  return {en::say("no frame tells what the experiment asks for"), scene, ""};
}

}  // namespace alltact
