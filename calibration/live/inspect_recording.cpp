#include "calibration/live/inspect_recording.h"

#include "calibration/finger/measuring_presets.h"
#include "core/batch/batch.h"
#include "core/finger/finger_store.h"
#include "core/open/open_source.h"
#include "core/sensing/pipeline.h"

namespace alltact {
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
  const PipelineSettings settings = measuring_settings(order.finger);
  auto pipelines = batch_pipelines(batch_threads(order.threads),
                                   [&] { return Pipeline::create(**finger, settings, job); });
  if (!pipelines) return pipelines.error();
  return inspect(**source, *pipelines, *(*finger)->mapping, order.recipe, job);
}

}  // namespace alltact
