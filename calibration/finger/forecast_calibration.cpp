#include "calibration/finger/forecast_calibration.h"

#include "calibration/finger/solve_presses.h"
#include "calibration/finger/take_presses.h"

#include <cmath>

namespace alltact {
namespace {

/// The samples of a press lie on a grid: the smallest step between two of them in a row.
int side_of(const std::vector<ResidualSample>& samples) {
  double side = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const Eigen::Vector2d step = samples[i].pixel - samples[i - 1].pixel;
    if (step.y() == 0 && step.x() > 0 && (side == 0 || step.x() < side)) side = step.x();
  }
  return std::max(1, static_cast<int>(std::lround(side)));
}

}  // namespace

Result<FingerCalibration> forecast_calibration(const Finger& finger,
                                               const std::vector<ReferencedPress>& presses,
                                               const CalibrationInputs& inputs,
                                               const Job& job) {
  FingerCalibration done;
  done.finger = finger;
  done.inputs = inputs;
  std::vector<std::optional<Reference>> references;
  for (const ReferencedPress& one : presses) {
    done.presses.push_back(one.taken);
    apply_notes(inputs.press_set, done.presses.back());
    references.push_back(one.reference);
  }
  if (const Status solved = solve_presses(done, references, {}, job, {}); !solved)
    return solved.error();
  return done;
}

std::optional<PressFit> fit_of_press(const Press& press,
                                     const Face& face,
                                     const MappingParameters& mapping,
                                     const Eigen::Vector3d& centre_mm) {
  if (!(press.ball_radius_mm > 0)) return std::nullopt;
  Calibration single;
  single.mapping = mapping;
  BallFit ball;
  ball.press = press.name;
  ball.radius_mm = press.ball_radius_mm;
  ball.centre_mm = centre_mm;
  single.balls.push_back(ball);
  auto residuals = press_residuals({&press}, face, single);
  if (residuals.empty()) return std::nullopt;
  PressFit fit{std::move(residuals.front())};
  int inner = 0;
  for (const ResidualSample& sample : fit.residuals.samples) {
    if (!(sample.rim <= kInnerRim) || !std::isfinite(sample.residual_mm)) continue;
    fit.error_mm += std::abs(sample.residual_mm);
    ++inner;
  }
  if (inner == 0) return std::nullopt;
  fit.error_mm /= inner;
  fit.side_px = side_of(fit.residuals.samples);
  return fit;
}

}  // namespace alltact
