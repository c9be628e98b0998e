#include "widgets/calibrating/press_looker.h"

namespace alltact {
Result<std::shared_ptr<PressLooker>> PressLooker::create(const std::filesystem::path& folder,
                                                         const Job& job) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  // With a mapping there would be depth instead of a difference.
  auto pipeline = Pipeline::create((*finger)->without_mapping(), {}, job);
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
  if (result->shape) looked.shape = std::make_shared<const FaceShape>(*result->shape);
  if (!result->difference || !result->shape) {
    looked.problem = Error{
        result->problems.empty() ? en::say("no face was found") : result->problems.front(), "", ""};
    return looked;
  }
  if (!(radius_mm > 0)) return looked;
  const Press press{
      frame->name, std::move(*result->difference), std::move(*result->shape), radius_mm};
  const auto ball = find_ball(press, pipeline_.finger().face);
  if (ball)
    looked.found_mm = ball->centre_mm;
  else
    looked.problem = Error{ball.error().what, "", ball.error().advice};
  return looked;
}

}  // namespace alltact
