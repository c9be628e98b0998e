// Forces frame after frame, by a finger's force model.
#pragma once

#include "core/finger/force_model.h"
#include "core/sensing/markers/markers.h"

#include <memory>
#include <optional>

#include <Eigen/Core>

namespace alltact {

/// What a model measures from: the markers' displacements from where they rest in it.
[[nodiscard]] ForceInput force_input(const ForceModel& model,
                                     const Markers& markers,
                                     const std::optional<Eigen::Vector2d>& place_mm);

/// Running mean of displacements, by which creep is told: dm/dt = (d - m) / creep_s. Starts anew
/// after a gap of more than 5 creep_s or where time goes back.
class CreepMean {
 public:
  explicit CreepMean(double creep_s) : creep_s_(creep_s) {}
  /// displacement less the running mean.
  [[nodiscard]] Eigen::VectorXd operator()(const Eigen::VectorXd& displacement_px, double time_s);
  void forget() { mean_.resize(0); }

 private:
  double creep_s_, last_s_ = 0;
  Eigen::VectorXd mean_;
};

/// Measures frame after frame. Remembers what creep needs, and nothing else.
class ForceMeter {
 public:
  explicit ForceMeter(std::shared_ptr<const ForceModel> model)
      : model_(std::move(model)), creep_(model_->creep_s) {}
  /// time_s: of capture; nullopt where there is none: creep is taken as none.
  [[nodiscard]] std::optional<Force> operator()(const Markers& markers,
                                                const std::optional<Eigen::Vector2d>& place_mm,
                                                std::optional<double> time_s);
  /// The next frame is not the neighbour of the last one in time.
  void forget() { creep_.forget(); }
  /// The model knows creep: what a frame tells depends on all before it.
  [[nodiscard]] bool creeps() const { return model_->creep_s > 0; }

 private:
  std::shared_ptr<const ForceModel> model_;
  CreepMean creep_;
};

}  // namespace alltact
