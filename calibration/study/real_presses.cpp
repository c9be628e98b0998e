#include "calibration/study/real_presses.h"

#include "calibration/checks/press_check.h"
#include "calibration/joint/calibrate.h"
#include "calibration/study/recommended_settings.h"
#include "calibration/study/study_machine.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace alltact {
namespace {

constexpr std::size_t kMaxFolds = 10;

Error stopped_among_presses() { return {en::say("stopped before the study was over"), "", ""}; }

FaceZone zone_of_contact(const Press& press, const Eigen::Vector3d& centre_mm) {
  // The zone follows from the column of the ball's centre, relative to the face's ends.
  const auto& columns = press.shape.columns();
  int first = -1, last = -1, nearest = -1;
  double least_px = 0;
  const auto pixel = press.shape.camera().project(centre_mm);
  for (int u = 0; u < press.shape.width_px(); ++u) {
    if (!columns[static_cast<std::size_t>(u)].valid) continue;
    if (first < 0) first = u;
    last = u;
    const double off_px = std::abs(u - (pixel ? pixel->x() : 0.0));
    if (nearest < 0 || off_px < least_px) nearest = u, least_px = off_px;
  }
  if (first < 0) return FaceZone::kMiddle;
  const auto at = [&](int u) {
    return press.shape.face().kind == FaceKind::kFlat ? static_cast<double>(u)
                                                      : columns[static_cast<std::size_t>(u)].z_mm;
  };
  const double low = std::min(at(first), at(last)), high = std::max(at(first), at(last));
  const double part = (at(nearest) - low) / std::max(high - low, 1e-6);
  return static_cast<FaceZone>(std::clamp(static_cast<int>(3 * part), 0, 2));
}

}  // namespace

std::optional<ErrorSpread> spread_of_errors(std::vector<float>& errors_mm) {
  if (errors_mm.empty()) return std::nullopt;
  std::sort(errors_mm.begin(), errors_mm.end());
  const std::size_t count = errors_mm.size();
  return ErrorSpread{errors_mm[count / 2], errors_mm[std::min(count - 1, count * 95 / 100)]};
}

CalibrationSettings fixed_to_mapping(const CalibrationSettings& settings,
                                     const MappingParameters& mapping) {
  CalibrationSettings fixed = settings;
  if (settings.method != CalibrationMethod::kJoint) return fixed;
  fixed.along = mapping.along == MappingAlong::kZ        ? AlongChoice::kZ
                : mapping.along == MappingAlong::kNormal ? AlongChoice::kNormal
                                                         : AlongChoice::kProjected;
  if (mapping.variation.is_none()) fixed.face_variation = FaceVariationChoice::kEven;
  // A layer model is stored as a polynomial, which does not hold its degree.
  if (settings.family == FamilyChoice::kAuto)
    fixed.family =
        mapping.kind == MappingKind::kMoebius ? FamilyChoice::kMoebius : FamilyChoice::kLayer;
  return fixed;
}

void RealErrorSum::add(const Press& press, const Face& face, const Mapping& mapping,
                       const Job& job) {
  const auto ball = ball_by_shape(press, face, mapping, job);
  if (!ball) {
    ++errors_.presses_missing;
    return;
  }
  ++errors_.presses;
  const auto zone = static_cast<std::size_t>(zone_of_contact(press, ball->centre_mm));
  for (const double error_mm : ball->errors_mm)
    by_zone_[zone].push_back(static_cast<float>(std::abs(error_mm)));
}

std::optional<RealErrors> RealErrorSum::errors() {
  std::vector<float> all;
  for (std::size_t zone = 0; zone < kFaceZones; ++zone) {
    all.insert(all.end(), by_zone_[zone].begin(), by_zone_[zone].end());
    errors_.depth_by_zone[zone] = spread_of_errors(by_zone_[zone]);
  }
  const auto spread = spread_of_errors(all);
  if (!spread) return std::nullopt;
  errors_.depth = *spread;
  return errors_;
}

Result<RealPresses> RealPresses::open(const FingerPtr& finger, const Job& job) {
  auto inputs = CalibrationInputs::load(finger->folder);
  if (!inputs) return inputs.error();
  auto library = ReferenceLibrary::load(*finger, job);
  if (!library) return library.error();
  RealPresses real(finger, std::move(inputs).value(), std::move(library).value());
  for (const StoredPress& press : real.inputs_.presses) {
    const PressNote& note = real.inputs_.press_set.of(press.name);
    if (note.excluded || !note.is_ball()) continue;
    auto frame = read_stored_press(finger->folder, press.name);
    if (!frame) return frame.error();
    real.frames_.push_back(std::move(frame).value());
  }
  if (real.frames_.size() < kMinPresses)
    return Error{
        en::say("the finger has too few stored presses to leave one out: {}", real.frames_.size()),
        (finger->folder / kPressFolder).string(),
        en::say("calibrating it with three presses or more")};
  return real;
}

Result<Pipeline> RealPresses::pipeline_of(const PipelineSettings& settings, const Job& job) const {
  const FingerSnapshot finger = finger_->without_mapping();
  if (settings.resolution == Resolution::kFull && settings.undistort)
    return Pipeline::with_library(library_, finger, settings);
  return Pipeline::create(finger, settings, job);
}

Result<std::vector<Press>> RealPresses::measured(const PipelineSettings& settings,
                                                 const Job& job) const {
  auto pipeline = pipeline_of(settings, job);
  if (!pipeline) return pipeline.error();
  std::vector<Press> presses;
  for (const FramePtr& frame : frames_) {
    if (job.stop_requested()) return stopped_among_presses();
    pipeline->forget();
    auto result = (*pipeline)(frame);
    if (!result) return result.error();
    if (!result->difference || !result->shape || result->reference->by_shape) continue;
    const PressNote& note = inputs_.press_set.of(frame->name);
    presses.push_back(Press{frame->name, std::move(*result->difference), std::move(*result->shape),
                            inputs_.press_set.radius_of(frame->name), note.ball_mm, note.depth});
  }
  return presses;
}

Result<RealErrors> RealPresses::held_out(const PipelineSettings& settings, const Job& job) const {
  const auto presses = measured(settings, job);
  if (!presses) return presses.error();
  const Face& face = finger_->finger.face;
  const Camera camera = finger_as_measured(*finger_, settings).camera;
  const CalibrationSettings chosen =
      fixed_to_mapping(inputs_.calibration, finger_->mapping->parameters());
  RealErrorSum sum;
  for (std::size_t missing = presses->size(); missing < frames_.size(); ++missing)
    sum.add_missing();
  const std::size_t folds = std::min(presses->size(), kMaxFolds);
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<Press> training, left;
    for (std::size_t i = 0; i < presses->size(); ++i)
      (i % folds == fold ? left : training).push_back((*presses)[i]);
    const auto calibration = calibrate(training, camera, face, chosen, job);
    if (job.stop_requested()) return stopped_among_presses();
    const auto mapping =
        calibration ? Mapping::create(calibration->mapping) : Result<Mapping>(calibration.error());
    for (const Press& press : left) {
      if (mapping)
        sum.add(press, face, *mapping, job);
      else
        sum.add_missing();
    }
  }
  const auto errors = sum.errors();
  if (!errors)
    return Error{en::say("none of {} presses could be compared with a mapping made without it",
                         frames_.size()),
                 finger_->folder.string(), en::say("more presses of different depth")};
  return *errors;
}

Status add_real_errors(AccuracyStudy& study, const RealPresses& presses,
                       const std::vector<std::size_t>& requested, const SaveRows& save,
                       const Job& job) {
  const StudyClock clock;
  for (std::size_t i = 0; i < requested.size(); ++i) {
    StudyRow& row = study.rows[requested[i]];
    if (row.real) continue;
    if (job.stop_requested()) return stopped_among_presses();
    clock.report(job, static_cast<double>(i) / static_cast<double>(requested.size()),
                 en::say("leaving out presses, {} of {}", i + 1, requested.size()));
    const auto errors = presses.held_out(row.settings, job);
    if (job.stop_requested()) return stopped_among_presses();
    if (!errors && requested[i] == 0) return errors.error();
    if (!errors) continue;
    row.real = *errors;
    if (save)
      if (const Status saved = save({row}); !saved) return saved;
  }
  return {};
}

std::vector<std::size_t> rows_for_real(const AccuracyStudy& study, bool all) {
  std::set<std::size_t> rows{0};
  const StudyPresets presets = presets_of(study);
  for (const auto& preset : {presets.fast, presets.finest})
    if (preset) rows.insert(*preset);
  if (all) {
    for (const std::size_t row : pareto_front(study)) rows.insert(row);
    for (std::size_t i = 0; i < study.rows.size(); ++i) {
      const PipelineSettings &row = study.rows[i].settings, &base = study.rows.front().settings;
      const auto differ =
          std::count_if(pipeline_settings().begin(), pipeline_settings().end(),
                        [&](const auto& setting) { return setting.get(row) != setting.get(base); });
      if (differ == 1) rows.insert(i);
    }
  }
  return {rows.begin(), rows.end()};
}

}  // namespace alltact
