#include "calibration/joint/measured_presses.h"

#include "calibration/joint/lift_off.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kFar = 4.0;  // standard deviations

bool is_far(double measured, double seen, double measured_sd, double seen_sd) {
  return std::abs(measured - seen) > kFar * std::hypot(measured_sd, seen_sd);
}

}  // namespace

std::vector<StepSamples> find_steps(const std::vector<Press>& presses,
                                    const Face& face,
                                    std::vector<Message>* left_out) {
  std::vector<StepSamples> steps;
  for (const Press& press : presses) {
    if (!press.step_mm) continue;
    auto step = find_step(press, face);
    if (step)
      steps.push_back(std::move(step).value());
    else
      left_out->push_back(en::say("{}.", step.error().message()));
  }
  return steps;
}

std::vector<StepFit> steps_of(const std::vector<StepSamples>& steps,
                              const MappingCurve& curve,
                              MappingAlong along) {
  std::vector<StepFit> fits;
  for (const StepSamples& step : steps) {
    const StepReading reading = read_step(step, curve, curve.values().data(), along);
    fits.push_back({step.press, step.step_mm, reading.height_mm, reading.sd_mm});
  }
  return fits;
}

std::vector<Message> drop_contradicting(const std::vector<MeasuredPress>& presses,
                                        std::vector<StepSamples>& steps,
                                        const CalibrationSettings& settings,
                                        const Job& job) {
  const bool any_depth = std::any_of(presses.begin(), presses.end(), [](const MeasuredPress& one) {
    return one.fine->given_depth.has_value();
  });
  if (!any_depth && steps.empty()) return {};
  ChoiceInput images_only;
  std::vector<PressSamples> without_depths;
  for (const MeasuredPress& one : presses) {
    without_depths.push_back(*one.coarse);
    without_depths.back().given_depth.reset();
    images_only.centres_mm.push_back(one.centre_mm);
  }
  for (const PressSamples& samples : without_depths) images_only.presses.push_back(&samples);
  const auto choice = choose_model(images_only, settings, job);
  if (!choice) return {};
  const Eigen::MatrixXd covariance =
      covariance_of(images_only.presses, choice->fit, choice->options).covariance;
  if (covariance.size() == 0) return {};

  std::vector<Message> reasons;
  const Eigen::Index numbers = choice->fit.curve.values().size();
  for (std::size_t i = 0; i < presses.size(); ++i) {
    const auto& measured = presses[i].fine->given_depth;
    if (!measured) continue;
    const Eigen::Vector3d& centre = choice->fit.centres_mm[i];
    const PressedPlane plane = plane_below(without_depths[i], centre);
    const auto first = numbers + 3 * static_cast<Eigen::Index>(i);
    const double seen_mm = without_depths[i].ball_radius_mm - plane.height_mm(centre);
    const double seen_sd_mm = std::sqrt(
        std::max(0.0, plane.normal.dot(covariance.block<3, 3>(first, first) * plane.normal)));
    if (!is_far(measured->mm, seen_mm, measured->sd_mm, seen_sd_mm)) continue;
    reasons.push_back(en::at(
        Message::typed(presses[i].name),
        en::say("its measured depth of {:.3f} +- {:.3f} mm was left out, because the pictures say "
                "{:.3f} +- {:.3f} mm; it counts from where the ball first touches, normal to the "
                "face",
                measured->mm,
                measured->sd_mm,
                seen_mm,
                seen_sd_mm)));
    presses[i].coarse->given_depth.reset();
    presses[i].fine->given_depth.reset();
  }
  std::erase_if(steps, [&](const StepSamples& step) {
    const MappingCurve& curve = choice->fit.curve;
    const StepReading seen = read_step(step, curve, curve.values().data(), choice->options.along);
    const double seen_sd_mm = std::sqrt(std::max(
        0.0, seen.by_values.dot(covariance.topLeftCorner(numbers, numbers) * seen.by_values)));
    if (!is_far(step.step_mm, seen.height_mm, seen.sd_mm, seen_sd_mm)) return false;
    reasons.push_back(en::at(
        Message::typed(step.press),
        en::say(
            "its step of {:.3f} mm was left out, because the balls say {:.3f} +- {:.3f} mm; is the "
            "balls' radius right",
            step.step_mm,
            seen.height_mm,
            std::hypot(seen.sd_mm, seen_sd_mm))));
    return true;
  });
  return reasons;
}

}  // namespace alltact
