// Where a touch is, how what touches is turned, and in which room that is seen.
#include "calibration/experiments/experiment_runs.h"
#include "calibration/study/evaluate.h"

#include <array>
#include <cmath>

namespace alltact {
namespace {

constexpr double kMiddleOfArray_mm = 60, kInnerReach_mm = 20, kTipRow_mm = 100;

/// Distance along the face of a region's place from the deepest point of what truly touches, both
/// on the pressed face, p_CF = p_LUF - (0, 0, d); what lies along the normal is depth, not place.
double place_error_mm(const ContactRegion& region, const ContactTruth& contact) {
  const Eigen::Vector3d deepest_mm = contact.point_mm - Eigen::Vector3d(0, 0, contact.depth_mm);
  const Eigen::Vector3d off = region.place_mm - deepest_mm;
  return (off - off.dot(contact.direction) * contact.direction).norm();
}

}  // namespace

Result<ExperimentOutcome> run_localisation(const ExperimentBench& bench) {
  ErrorSamples inner, tip, all;
  int missed = 0;
  const auto frames =
      bench.measure("experiment_localisation",
                    {PipelineSettings{}},
                    [&](std::size_t, const Truth& truth, const FrameResult& result) {
                      if (result.regions.empty()) {
                        ++missed;
                        return;
                      }
                      const ContactTruth& contact = truth.contacts.front();
                      const double error = place_error_mm(result.regions.front(), contact);
                      all.add(error);
                      if (std::abs(contact.along_mm - kMiddleOfArray_mm) <= kInnerReach_mm)
                        inner.add(error);
                      if (contact.along_mm >= kTipRow_mm) tip.add(error);
                    });
  if (!frames) return frames.error();
  if (inner.count == 0 || tip.count == 0) return untold("experiment_localisation");
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  outcome.figures = {
      {en::say("place, mean error within +-20 mm of the middle"), "mm", inner.mean(), 0.814, 0.2},
      {en::say("place, mean error at the tip"), "mm", tip.mean(), 2.93, 0.5},
      {en::say("place, greatest error"), "mm", all.greatest, {}, {}},
      {en::say("touches that are found"), "%", percent_of(all.count, *frames), {}, {}, true},
  };
  return outcome;
}

Result<ExperimentOutcome> run_pose(const ExperimentBench& bench) {
  ErrorSamples errors;
  const auto frames =
      bench.measure("experiment_pose",
                    {PipelineSettings{}},
                    [&](std::size_t, const Truth& truth, const FrameResult& result) {
                      if (result.regions.empty() || !result.regions.front().angle_deg) return;
                      const double off = *result.regions.front().angle_deg -
                                         truth.contacts.front().angle_deg.value();
                      errors.add(std::abs(std::remainder(off, 180.0)));  // a bar has no front
                    });
  if (!frames) return frames.error();
  if (errors.count == 0) return untold("experiment_pose");
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  outcome.figures = {
      {en::say("angle, mean error"), "degrees", errors.mean(), 3.22, 1.0},
      {en::say("angle, greatest error"), "degrees", errors.greatest, 12.06, 1.0},
      {en::say("bars whose angle is told"), "%", percent_of(errors.count, *frames), {}, {}, true},
  };
  outcome.remarks = {
      en::say("The lesser of the paper's two figures stands beside the mean error, the greater one "
              "beside the greatest error")};
  return outcome;
}

Result<ExperimentOutcome> run_room_light(const ExperimentBench& bench) {
  static constexpr std::array kRooms_lux{300, 1100, 2500};
  PipelineSettings uncorrected;
  uncorrected.light = LightChange::kIgnored;
  std::vector<Evaluator> corrected_errors(kRooms_lux.size(), Evaluator(bench.finger().camera));
  Evaluator uncorrected_errors(bench.finger().camera);  // in the last room
  std::size_t number = 0;
  const auto frames =
      bench.measure("experiment_room_light",
                    {PipelineSettings{}, uncorrected},
                    [&](std::size_t which, const Truth& truth, const FrameResult& result) {
                      const std::size_t room = number / 3;  // of three frames each
                      if (which == 1) ++number;
                      if (which == 1 && room + 1 < kRooms_lux.size()) return;
                      Evaluator& errors = which == 0 ? corrected_errors[room] : uncorrected_errors;
                      if (!result.depth) return errors.add_missing();
                      errors.add(truth,
                                 result.depth->depth_mm,
                                 contact_face_points_mm(result, bench.finger().finger.face),
                                 result.markers.value_or(Markers{}));
                    });
  if (!frames) return frames.error();
  ExperimentOutcome outcome;
  outcome.frames = *frames;
  for (std::size_t room = 0; room < kRooms_lux.size(); ++room) {
    const auto error = corrected_errors[room].evaluation().contact_depth_mm;
    if (!error) return untold("experiment_room_light");
    outcome.figures.push_back(
        {en::say("depth inside contacts, mean error at {} lux", kRooms_lux[room]),
         "mm",
         *error,
         {},
         {}});
  }
  const auto error = uncorrected_errors.evaluation().contact_depth_mm;
  if (!error) return untold("experiment_room_light");
  outcome.figures.push_back(
      {en::say("the same at {} lux, without correction of the light", kRooms_lux.back()),
       "mm",
       *error,
       {},
       {}});
  outcome.remarks = {en::say(
      "How much of a room's light gets into a finger is a guess of the scene, 4 grey levels "
      "of a white surface for every 1000 lux")};
  return outcome;
}

}  // namespace alltact
