#include "calibration/live/inspect_recording.h"

#include "calibration/finger/measuring_presets.h"
#include "core/finger/finger_store.h"
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"

#include <algorithm>

#include <opencv2/core/utility.hpp>

namespace alltact {
namespace {

constexpr int kMostThreads = 64;

}  // namespace

Result<InspectionLog> inspect_recording(const InspectionOrder& order, const Job& job) {
  const auto finger = open_finger(order.finger);
  if (!finger) return finger.error();
  if (!(*finger)->mapping)
    return Error{en::say("the finger is not calibrated yet"), order.finger,
                 en::say("alltact calibrate with ball presses")};
  SourceOptions how;
  how.pace = Pace::kOnDemand;
  how.job = &job;
  auto source = open_source(order.inputs, how);
  if (!source) return source.error();
  const int threads =
      order.threads > 0 ? order.threads : std::clamp(cv::getNumberOfCPUs(), 1, kMostThreads);
  const PipelineSettings settings = measuring_settings(order.finger);
  std::vector<Pipeline> pipelines;
  while (pipelines.size() < static_cast<std::size_t>(threads)) {
    auto pipeline = Pipeline::create(**finger, settings, job);
    if (!pipeline) return pipeline.error();
    pipelines.push_back(std::move(*pipeline));
    if (pipelines.front().has_long_memory()) break;
  }
  return inspect(**source, pipelines, order.recipe, job);
}

}  // namespace alltact
