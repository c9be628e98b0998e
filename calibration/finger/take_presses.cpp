#include "calibration/finger/take_presses.h"

#include "calibration/presses/held_frames.h"
#include "core/io/picture.h"
#include "core/sensing/pipeline.h"
#include "core/sources/open/open_source.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

namespace alltact {
namespace {

Error stopped() {
  return {en::say("stopped before the calibration was done"), "", ""};
}

Result<Pipeline> make_pipeline(const CalibrationWork& work,
                               const FingerCalibration& done,
                               const Job& job) {
  Finger blank = done.finger;  // the old mapping must not matter
  blank.mapping.reset();
  if (!work.untouched) return Pipeline::create(work.folder, blank, done.inputs.pipeline, job);
  const auto grey =
      oriented_for(blank.camera,
                   work.untouched->grey,
                   en::say("the reference picture"),
                   work.untouched->origin,
                   en::say("the untouched picture of this sensor, at the size of its presses"));
  if (!grey) return grey.error();
  auto library = ReferenceLibrary::single(*grey);
  if (!library) return library.error();
  return Pipeline::create(blank, std::move(library).value(), done.inputs.pipeline);
}

/// The picture that was kept must be the one that was calibrated with.
Status check_kept(const CalibrationWork& work, const Frame& frame, std::size_t index) {
  if (!work.is_repetition) return {};
  const KeptPress& kept = work.kept.presses[index];
  if (frame.name == kept.name && picture_checksum(frame.grey) == kept.checksum) return {};
  return Error{en::say("this is not the picture that the finger was calibrated with"),
               work.pictures[index].string(),
               en::say("calibrating anew with the pictures that are there")};
}

void say_of(Press& press, const SaidOfPresses& said) {
  if (const auto* ball = said_of(said.balls, press.name)) press.ball_mm = ball->centre_mm;
  if (const auto* told = said_of(said.depths, press.name)) press.told_depth = told->depth;
  if (const auto* punch = said_of(said.steps, press.name)) press.step_mm = punch->step_mm;
}

TakenPress press_of(const Frame& frame, FrameResult& result, const CalibrationInputs& inputs) {
  TakenPress press{frame.name, result.grey, std::nullopt, "", {}};
  if (result.difference) press.sign.light_change = result.difference->light.change();
  if (result.reference) press.sign.known_pose = result.reference->known_pose;
  // A press tells the mapping: one whose markers are hidden is not worth its less sure reference.
  if (result.difference && result.shape && !result.reference->by_shape) {
    press.press = Press{frame.name,
                        std::move(*result.difference),
                        std::move(*result.shape),
                        inputs.radius_of(frame.name)};
    say_of(*press.press, inputs);
  } else {
    press.left_out =
        result.problems.empty() ? en::say("no face was found") : result.problems.front();
  }
  if (const ExcludedPress* excluded = said_of(inputs.excluded, frame.name))
    press.left_out = en::list({en::say("excluded"), Message::typed(excluded->because)});
  return press;
}

Result<std::unique_ptr<Source>> open_presses(const CalibrationWork& work) {
  if (work.bursts) return std::unique_ptr<Source>(std::make_unique<BurstSource>(work.pictures));
  auto source = open_source(work.pictures);
  if (source || std::none_of(work.pictures.begin(), work.pictures.end(), is_video)) return source;
  Error several = source.error();
  several.advice = en::list(
      {several.advice, en::say("or --bursts where each video shows one press held still")});
  return several;
}

Status measure_presses(CalibrationWork& work,
                       Pipeline& pipeline,
                       FingerCalibration& done,
                       const Job& job) {
  auto source = open_presses(work);
  if (!source) return source.error();
  if (!work.is_repetition) done.inputs.is_continuous = (*source)->is_continuous();
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
    if (const Status status = check_kept(work, *frame, work.frames.size()); !status) return status;
    if (count > 0)
      job.report(0.5 * static_cast<double>(names.size() - 1) / count,
                 en::say("reading {}", frame->name));
    if (!done.inputs.is_continuous) pipeline.forget();
    auto result = pipeline(frame);
    if (!result) return result.error();
    done.presses.push_back(press_of(*frame, *result, done.inputs));
    work.references.push_back(std::move(result->reference));
    work.frames.push_back(frame);
  }
  if (const auto* bursts = dynamic_cast<const BurstSource*>(source->get()))
    done.made_of = bursts->made_of();
  return {};
}

/// What is said of single presses must be said of presses that are there.
Status check_names(const FingerCalibration& done) {
  std::set<std::string> names;
  for (const TakenPress& press : done.presses) names.insert(press.name);
  for (const std::string& name : done.inputs.names())
    if (!names.contains(name))
      return Error{en::say("no press is called '{}'", name),
                   "",
                   en::say("one of {}", fmt::format("{}", fmt::join(names, ", ")))};
  return {};
}

}  // namespace

Status take_presses(CalibrationWork& work, FingerCalibration& done, const Job& job) {
  auto pipeline = make_pipeline(work, done, job);
  if (!pipeline) return pipeline.error();
  if (const Status status = measure_presses(work, *pipeline, done, job); !status) return status;
  return check_names(done);
}

}  // namespace alltact
