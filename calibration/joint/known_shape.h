// Bodies of known shape but balls, as evidence of the scale of depth: what steps of punches
// (step_press.h) and meshes (body_press.h) have in common for the joint fit.
#pragma once

#include "calibration/joint/body_press.h"
#include "calibration/joint/mapping_curve.h"
#include "calibration/joint/step_press.h"
#include "calibration/presses/press.h"
#include "core/base/job.h"
#include "core/base/message.h"
#include "core/finger/finger.h"

#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct KnownShape : std::variant<StepSamples, BodySamples> {
  using variant::variant;
};

[[nodiscard]] inline const std::string& press_of(const KnownShape& shape) {
  return std::visit([](const auto& of) -> const std::string& { return of.press; }, shape);
}
[[nodiscard]] inline const PressSamples& samples_of(const KnownShape& shape) {
  return std::visit([](const auto& of) -> const PressSamples& { return of.samples; }, shape);
}
[[nodiscard]] inline PressSamples& samples_of(KnownShape& shape) {
  return std::visit([](auto& of) -> PressSamples& { return of.samples; }, shape);
}

/// Finds the punches among presses. `left_out` receives the reasons of unusable ones.
[[nodiscard]] std::vector<KnownShape> find_steps(const std::vector<Press>& presses,
                                                 const Face& face, std::vector<Message>* left_out);

/// Finds the other bodies among presses, likewise, as a curve reads the skin on them. `area`: of
/// the curve's variation.
[[nodiscard]] std::vector<KnownShape> find_bodies(const std::vector<Press>& presses,
                                                  const Face& face, const PressedArea& area,
                                                  const MappingCurve& curve, MappingAlong along,
                                                  const Job& job, std::vector<Message>* left_out);

/// A body whose scale differs from that of the balls by so many standard deviations contradicts
/// them.
constexpr double kContradictionSds = 4.0;

/// The scale of depth that a curve has by one shape.
struct ScaleReading {
  double scale = 1;           ///< depth read / true depth
  double sd = 0;              ///< of the scale, by noise and by skin that does not follow the body
  Eigen::VectorXd by_values;  ///< derivative of the scale by the curve's numbers
};
/// `values`: the curve's own, or those in a solver.
[[nodiscard]] ScaleReading read_scale(const KnownShape& shape, const MappingCurve& curve,
                                      const double* values, MappingAlong along);

}  // namespace alltact
