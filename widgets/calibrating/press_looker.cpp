#include "widgets/calibrating/press_looker.h"

#include "calibration/finger/take_presses.h"

namespace alltact {

Result<std::shared_ptr<PressLooker>> PressLooker::create(const std::filesystem::path& folder,
                                                         const Job& job) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  // As the finger was calibrated last, so that what is forecast is what calibrating gives.
  const auto inputs = CalibrationInputs::load(folder);
  const PipelineSettings settings = for_presses(inputs ? inputs->pipeline : PipelineSettings());
  // With a mapping there would be depth instead of a difference.
  auto pipeline = Pipeline::create((*finger)->without_mapping(), settings, job);
  if (!pipeline) return pipeline.error();
  return std::shared_ptr<PressLooker>(new PressLooker(std::move(*pipeline)));
}

LookedAt PressLooker::operator()(const FramePtr& frame, double radius_mm) {
  LookedAt looked;
  pipeline_.forget();
  auto result = pipeline_(frame);
  if (!result) {
    looked.problem = result.error();
    return looked;
  }
  looked.grey = result->grey;
  auto measured = std::make_shared<ReferencedPress>();
  measured->taken = press_of(frame->name, *result);
  measured->reference = std::move(result->reference);
  looked.measured = measured;
  if (!measured->taken.press) {
    if (result->shape) looked.shape = std::make_shared<const FaceShape>(*result->shape);
    looked.problem = Error{measured->taken.left_out, "", ""};
    return looked;
  }
  looked.shape = std::shared_ptr<const FaceShape>(measured, &measured->taken.press->shape);
  if (!(radius_mm > 0)) return looked;
  Press press = *measured->taken.press;
  press.ball_radius_mm = radius_mm;
  const auto ball = find_ball(press, pipeline_.finger().face);
  if (ball)
    looked.found_mm = ball->centre_mm;
  else
    looked.problem = Error{ball.error().what, "", ball.error().advice};
  return looked;
}

}  // namespace alltact
