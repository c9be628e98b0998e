#include "calibration/joint/known_shape.h"

#include <utility>

namespace alltact {
namespace {

ScaleReading scale_of(const StepSamples& step, const MappingCurve& curve, const double* values,
                      MappingAlong along) {
  const StepReading reading = read_step(step, curve, values, along);
  return {reading.height_mm / step.step_mm, reading.sd_mm / step.step_mm,
          reading.by_values / step.step_mm};
}

ScaleReading scale_of(const BodySamples& body, const MappingCurve& curve, const double* values,
                      MappingAlong along) {
  const BodyReading reading = read_body(body, curve, values, along);
  const double scale = 1 / reading.factor;
  return {scale, scale * scale * reading.sd, -scale * scale * reading.by_values};
}

}  // namespace

std::vector<KnownShape> find_steps(const std::vector<Press>& presses, const Face& face,
                                   std::vector<Message>* left_out) {
  std::vector<KnownShape> steps;
  for (const Press& press : presses) {
    if (!press.step_mm) continue;
    auto step = find_step(press, face);
    if (step)
      steps.emplace_back(std::move(step).value());
    else
      left_out->push_back(en::say("{}.", step.error().message()));
  }
  return steps;
}

std::vector<KnownShape> find_bodies(const std::vector<Press>& presses, const Face& face,
                                    const PressedArea& area, const MappingCurve& curve,
                                    MappingAlong along, const Job& job,
                                    std::vector<Message>* left_out) {
  std::vector<KnownShape> bodies;
  for (const Press& press : presses) {
    if (!press.body || job.stop_requested()) continue;
    job.report(static_cast<double>(&press - presses.data()) / static_cast<double>(presses.size()),
               en::say("looking for the body in {}", press.name));
    PressSamples samples = sample_for_body(press, face);
    set_unit_positions(area, &samples);
    auto body = find_body(press.name, std::move(samples), *press.body->shape, curve, along, job);
    if (body)
      bodies.emplace_back(std::move(body).value());
    else
      left_out->push_back(en::say("{}.", body.error().message()));
  }
  return bodies;
}

ScaleReading read_scale(const KnownShape& shape, const MappingCurve& curve, const double* values,
                        MappingAlong along) {
  return std::visit([&](const auto& of) { return scale_of(of, curve, values, along); }, shape);
}

}  // namespace alltact
