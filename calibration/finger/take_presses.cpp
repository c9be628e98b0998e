#include "calibration/finger/take_presses.h"

#include "calibration/finger/paper_pipeline.h"
#include "core/io/image_file.h"
#include "core/sensing/pipeline.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

Error stopped() {
  return {en::say("stopped before the calibration was done"), "", ""};
}

/// Of the untouched image that is to be installed.
Result<ReferenceLibrary> flat_library(const CalibrationWork& work, const Finger& finger) {
  const auto grey =
      oriented_for(finger.camera,
                   work.untouched->grey,
                   en::say("the reference picture"),
                   work.untouched->origin,
                   en::say("the untouched picture of this sensor, at the size of its presses"));
  if (!grey) return grey.error();
  return ReferenceLibrary::single(*grey);
}

Result<PaperMethod> paper_method_of(const CalibrationWork& work,
                                    const FingerSnapshot& blank,
                                    const Job& job) {
  if (!work.untouched) return PaperMethod::create(blank, job);
  auto library = flat_library(work, blank.finger);
  if (!library) return library.error();
  return PaperMethod::flat(std::move(library).value(), blank);
}

Result<Pipeline> make_pipeline(const CalibrationWork& work,
                               const FingerCalibration& done,
                               const Job& job) {
  auto full = FingerSnapshot::of(work.store->folder(), done.finger);
  if (!full) return full.error();
  // the earlier mapping must have no influence
  const FingerSnapshot blank = full->without_mapping();
  if (done.inputs.calibration.method == CalibrationMethod::kPaper) {
    auto method = paper_method_of(work, blank, job);
    if (!method) return method.error();
    return Pipeline::with_paper_method(std::move(method).value());
  }
  if (!work.untouched)
    return Pipeline::create(blank, settings_for_presses(done.inputs.pipeline), job);
  auto library = flat_library(work, done.finger);
  if (!library) return library.error();
  return Pipeline::with_library(
      std::move(library).value(), blank, settings_for_presses(done.inputs.pipeline));
}

/// The stored image must be unchanged since the calibration.
Status check_stored(const CalibrationWork& work, const Frame& frame, std::size_t index) {
  if (!work.is_repetition) return {};
  const StoredPress& stored = work.stored.presses[index];
  if (frame.name == stored.name && image_checksum(frame.grey) == stored.checksum) return {};
  return Error{en::say("this is not the picture that the finger was calibrated with"),
               work.presses.files[index].string(),
               en::say("calibrating anew with the pictures that are there")};
}

Status measure_presses(CalibrationWork& work,
                       Pipeline& pipeline,
                       FingerCalibration& done,
                       const Job& job) {
  PressInput input = work.presses;
  input.frames_per_press = static_cast<std::size_t>(done.inputs.calibration.frames_per_press);
  auto source = open_presses(input);
  if (!source) return source.error();
  if (!work.is_repetition) done.inputs.is_continuous = is_one_video(**source);
  const double count = static_cast<double>((*source)->count().value_or(0));
  std::set<std::string> names;
  while (true) {
    if (job.stop_requested()) return stopped();
    auto next = (*source)->next();
    if (!next) return next.error();
    if (!*next) break;
    const FramePtr frame = *next;
    if (!names.insert(frame->name).second)
      return Error{
          en::say("two presses are called '{}'", frame->name),
          frame->origin,
          en::say("giving the pictures different names; they are kept by name with the finger")};
    if (const Status status = check_stored(work, *frame, work.frames.size()); !status)
      return status;
    if (count > 0)
      job.report(0.5 * static_cast<double>(names.size() - 1) / count,
                 en::say("reading {}", frame->name));
    if (!done.inputs.is_continuous) pipeline.forget();
    auto result = pipeline(frame);
    if (!result) return result.error();
    done.presses.push_back(press_of(frame->name, *result));
    apply_notes(done.inputs.press_set, done.presses.back());
    work.references.push_back(std::move(result->reference));
    work.frames.push_back(frame);
  }
  done.made_of = made_of(**source);
  return {};
}

/// Notes must name existing presses.
Status check_names(const FingerCalibration& done) {
  std::set<std::string> names;
  for (const TakenPress& press : done.presses) names.insert(press.name);
  for (const auto& [name, note] : done.inputs.press_set.notes)
    if (!names.contains(name))
      return Error{en::say("no press is called '{}'", name),
                   "",
                   en::say("one of {}", fmt::format("{}", fmt::join(names, ", ")))};
  return {};
}

}  // namespace

TakenPress press_of(const std::string& name, FrameResult& result) {
  TakenPress press{name, result.grey, std::nullopt, "", {}};
  if (result.difference) press.sign.light_change = result.difference->light.change();
  if (result.reference) press.sign.known_pose = result.reference->known_pose;
  // A press with hidden markers is left out: its reference is less certain, and would degrade the
  // mapping.
  if (result.difference && result.shape && !result.reference->by_shape)
    press.press = Press{name, std::move(*result.difference), std::move(*result.shape)};
  else
    press.left_out =
        result.problems.empty() ? en::say("no face was found") : result.problems.front();
  return press;
}

void apply_notes(const PressSet& press_set, TakenPress& press) {
  const PressNote& note = press_set.of(press.name);
  if (press.press) {
    press.press->ball_radius_mm = press_set.radius_of(press.name);
    press.press->ball_mm = note.ball_mm;
    press.press->given_depth = note.depth;
    press.press->step_mm = note.step_mm;
  }
  if (note.excluded)
    press.left_out = en::list({en::say("excluded"), Message::typed(*note.excluded)});
}

Result<std::vector<Press>> take_presses_as_paper(const CalibrationWork& work,
                                                 const FingerCalibration& done,
                                                 const Job& job) {
  const auto full = FingerSnapshot::of(work.store->folder(), done.finger);
  if (!full) return full.error();
  auto method = paper_method_of(work, full->without_mapping(), job);
  if (!method) return method.error();
  return paper_presses(*method, work.frames, done.inputs.press_set, job);
}

Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job) {
  auto pipeline = make_pipeline(work, done, job);
  if (!pipeline) return pipeline.error();
  if (const Status status = measure_presses(work, *pipeline, done, job); !status) return status;
  return check_names(done);
}

}  // namespace alltact
