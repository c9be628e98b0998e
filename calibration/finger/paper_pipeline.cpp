#include "calibration/finger/paper_pipeline.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/joint/outline_methods.h"

namespace alltact {

Result<std::vector<Press>> paper_presses(PaperMethod& method, const std::vector<FramePtr>& frames,
                                         const PressSet& press_set, const Job& job) {
  std::vector<Press> presses;
  Message reason = en::say("all are excluded");
  for (const FramePtr& frame : frames) {
    if (job.stop_requested()) return Error{en::say("stopped before there was a solution"), "", ""};
    const PressNote& note = press_set.of(frame->name);
    if (note.excluded || !note.is_ball()) continue;
    method.forget();
    auto result = method.measure(frame);
    if (!result) return result.error();
    if (!result->difference) {
      if (!result->problems.empty()) reason = result->problems.front();
      continue;
    }
    presses.push_back(Press{frame->name, std::move(*result->difference), std::move(*result->shape),
                            press_set.radius_of(frame->name), note.ball_mm});
  }
  if (presses.empty())
    return Error{en::say("the source paper's method can measure none of {} presses ({})",
                         frames.size(), reason),
                 "", en::say("our own method")};
  return presses;
}

Result<Pipeline> paper_pipeline(const FingerSnapshot& finger, const Job& job) {
  const auto& record = finger.finger.mapping_record;
  if (finger.mapping && record && record->method == method_name(CalibrationMethod::kPaper)) {
    auto method = PaperMethod::create(finger, job);
    if (!method) return method.error();
    return Pipeline(std::make_unique<PaperMethod>(std::move(method).value()));
  }
  const auto inputs = CalibrationInputs::load(finger.folder);
  if (!inputs)
    return Error{en::say("the source paper's method calibrates differently, and this finger has no "
                         "stored presses for it"),
                 (finger.folder / CalibrationInputs::kFileName).string(),
                 en::say("alltact calibrate with ball presses")};
  std::vector<FramePtr> frames;
  for (const StoredPress& press : inputs->presses) {
    auto frame = read_stored_press(finger.folder, press.name);
    if (!frame) return frame.error();
    frames.push_back(std::move(frame).value());
  }
  auto method = PaperMethod::create(finger.without_mapping(), job);
  if (!method) return method.error();
  const auto presses = paper_presses(*method, frames, inputs->press_set, job);
  if (!presses) return presses.error();
  const auto calibration = calibrate_as_paper(*presses, finger.camera, finger.finger.face, job);
  if (!calibration) return calibration.error();
  auto mapping = Mapping::create(calibration->mapping);
  if (!mapping) return mapping.error();
  return Pipeline(std::make_unique<PaperMethod>(method->with(std::move(mapping).value())));
}

}  // namespace alltact
