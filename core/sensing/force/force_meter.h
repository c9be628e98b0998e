// Estimates forces frame by frame with a finger's force model.
#pragma once

#include "core/finger/force_model.h"
#include "core/sensing/markers/markers.h"

#include <memory>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// Input of a model: the markers' displacements from its rest positions.
[[nodiscard]] ForceInput force_input(const ForceModel& model, const Markers& markers,
                                     const std::optional<Eigen::Vector2d>& position_mm);

/// Running mean of displacements, from which creep is estimated: dm/dt = (d - m) / creep_s.
/// Restarts after a gap of more than 5 creep_s, and where time goes back.
class CreepMean {
 public:
  explicit CreepMean(double creep_s) : creep_s_(creep_s) {}
  /// Returns the displacement minus the running mean.
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& displacement_px, double time_s);
  void forget() { mean_.resize(0); }

 private:
  double creep_s_, last_s_ = 0;
  Eigen::VectorXd mean_;
};

/// Stores only the state that creep requires.
class ForceMeter {
 public:
  explicit ForceMeter(std::shared_ptr<const ForceModel> model)
      : model_(std::move(model)), creep_(model_->creep_s) {}
  /// time_s: of capture; nullopt: creep is not corrected.
  [[nodiscard]] std::optional<Force> operator()(const Markers& markers,
                                                const std::optional<Eigen::Vector2d>& position_mm,
                                                std::optional<double> time_s);
  /// Resets the state: the next frame does not follow the last one in time.
  void forget() { creep_.forget(); }
  /// True when the model includes creep, so that a result depends on all frames before it.
  [[nodiscard]] bool has_creep() const { return model_->creep_s > 0; }

 private:
  std::shared_ptr<const ForceModel> model_;
  CreepMean creep_;
};

}  // namespace alltact
