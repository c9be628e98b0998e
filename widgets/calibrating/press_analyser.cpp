#include "widgets/calibrating/press_analyser.h"

#include "calibration/finger/take_presses.h"

namespace alltact {

Result<std::shared_ptr<PressAnalyser>> PressAnalyser::create(const std::filesystem::path& folder,
                                                             const Job& job) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  // The settings of the last calibration, so that a forecast equals its result.
  const auto inputs = CalibrationInputs::load(folder);
  const PipelineSettings settings =
      settings_for_presses(inputs ? inputs->pipeline : PipelineSettings());
  // A mapping would replace the brightness difference by depth.
  auto pipeline = Pipeline::create((*finger)->without_mapping(), settings, job);
  if (!pipeline) return pipeline.error();
  return std::shared_ptr<PressAnalyser>(new PressAnalyser(std::move(*pipeline)));
}

PressAnalysis PressAnalyser::operator()(const FramePtr& frame, double radius_mm) {
  PressAnalysis analysis;
  pipeline_.forget();
  auto result = pipeline_(frame);
  if (!result) {
    analysis.problem = result.error();
    return analysis;
  }
  analysis.grey = result->grey;
  auto measured = std::make_shared<ReferencedPress>();
  measured->taken = press_of(frame->name, *result);
  measured->reference = std::move(result->reference);
  analysis.measured = measured;
  if (!measured->taken.press) {
    if (result->shape) analysis.shape = std::make_shared<const FaceShape>(*result->shape);
    analysis.problem = Error{measured->taken.left_out, "", ""};
    return analysis;
  }
  analysis.shape = std::shared_ptr<const FaceShape>(measured, &measured->taken.press->shape);
  if (!(radius_mm > 0)) return analysis;
  Press press = *measured->taken.press;
  press.ball_radius_mm = radius_mm;
  const auto ball = find_ball(press, pipeline_.finger().face);
  if (ball)
    analysis.found_mm = ball->centre_mm;
  else
    analysis.problem = Error{ball.error().what, "", ball.error().advice};
  return analysis;
}

}  // namespace alltact
