#include "calibration/finger/calibrate_finger.h"

#include "calibration/finger/calibrate_presses.h"
#include "calibration/finger/calibration_file.h"
#include "calibration/finger/calibration_report.h"
#include "calibration/presses/press_bodies.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/report/problem_image.h"
#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/mesh/mesh_file.h"
#include "core/sensing/reference/recorded_poses.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <opencv2/core.hpp>

namespace alltact {
namespace {

constexpr const char* kPressProblem = "calibration.problem.png";

constexpr std::size_t kMaxShown = 8;
constexpr double kDarker = 0.02;  // of the untouched brightness: fainter marks are noise

/// Why a press is not used; empty: it is, or a person excluded it.
std::string reason_of(const MeasuredPress& press, const FingerCalibration& done) {
  if (done.inputs.press_set.of(press.name).excluded) return {};
  if (!press.left_out.empty()) return press.name + ": " + press.left_out.english();
  for (const Message& message : done.calibration.left_out)
    if (std::string sentence = message.english(); sentence.starts_with(press.name + ':'))
      return sentence;
  return {};
}

cv::Mat image_of(const MeasuredPress& press, const std::string& words) {
  ProblemScene scene;
  scene.grey = press.grey;
  scene.words = {words};
  if (press.press) {
    scene.edges = edge_curves(press.press->shape);
    scene.darker = press.press->difference.x > kDarker;
  }
  return problem_image(scene);
}

/// The presses that were left out, one below the other (problem_image.h), each with its reason;
/// eight at most, without those that a person excluded. `refused`: why there is no calibration at
/// all, in English; presses without a reason of their own are then shown as well. Empty where there
/// is nothing to show.
cv::Mat press_problem(const FingerCalibration& done, const std::string& refused) {
  std::vector<cv::Mat> images;
  const auto add = [&](const MeasuredPress& press, const std::string& words) {
    if (images.size() < kMaxShown && !press.grey.empty()) images.push_back(image_of(press, words));
  };
  for (const MeasuredPress& press : done.presses)
    if (const std::string reason = reason_of(press, done); !reason.empty()) add(press, reason);
  if (images.empty() && !refused.empty())
    for (const MeasuredPress& press : done.presses)
      if (press.left_out.empty()) add(press, press.name + ": " + refused);
  cv::Mat stacked;
  if (!images.empty()) cv::vconcat(images, stacked);  // one camera: all are equally wide
  return stacked;
}

/// Writes that image into the finger's folder, or removes that of an earlier calibration. Returns
/// its path; empty where there is none.
std::filesystem::path leave_press_problem(const std::filesystem::path& finger_folder,
                                          const FingerCalibration& done,
                                          const std::string& refused) {
  const auto file = finger_folder / kPressProblem;
  const cv::Mat image = press_problem(done, refused);
  if (!image.empty() && write_image(file, image)) return file;
  std::error_code absent;
  std::filesystem::remove(file, absent);
  return {};
}

namespace fs = std::filesystem;

void record(FingerCalibration& done) {
  Finger& finger = done.finger;
  const CalibrationInputs& inputs = done.inputs;
  finger.mapping = done.calibration.mapping;
  finger.mapping_record = record_of(done);
  finger.provenance["calibration_date"] = inputs.date;
  finger.provenance["calibration_inputs"] = CalibrationInputs::kFileName;
  finger.provenance["calibration_version"] = inputs.program_version;
  if (!inputs.press_set.operator_name.empty())
    finger.provenance["operator"] = inputs.press_set.operator_name;
  finger.provenance["ball_radius_mm"] = fmt::format("{}", inputs.press_set.ball_radius_mm);
}

/// Records the settings of all recordings.
void settle_finger(const CalibrationWork& work, FingerCalibration& done) {
  // The settings of earlier presses are obsolete, also for a new reference.
  [[maybe_unused]] const auto none =
      record_settings(SettingsMonitor(), RecordingKind::kPresses, done.finger);
  if (work.untouched) {
    Frame frame;
    if (!work.untouched->controls.empty())
      frame.controls = std::make_shared<const std::string>(work.untouched->controls);
    SettingsMonitor settings;
    settings.add(frame);
    done.about_settings = record_settings(settings, RecordingKind::kReference, done.finger);
  }
  SettingsMonitor settings;
  for (const FramePtr& frame : work.frames) settings.add(*frame);
  const auto warnings = record_settings(settings, RecordingKind::kPresses, done.finger);
  done.about_settings.insert(done.about_settings.end(), warnings.begin(), warnings.end());
}

/// Checksums and version of everything else that the result depends on.
void sign_inputs(const CalibrationWork& work, FingerCalibration& done) {
  CalibrationInputs& inputs = done.inputs;
  inputs.finger_checksum = finger_checksum(done.finger);
  inputs.presses.clear();
  for (const FramePtr& frame : work.frames)
    inputs.presses.push_back({frame->name, image_checksum(frame->grey)});
  const std::string now = utc_not_before(provenance_of(done.finger, "reference_date"));
  if (!work.stored) {
    if (inputs.date.empty()) inputs.date = now;
    return;
  }
  const CalibrationInputs& stored = *work.stored;
  if (inputs.reference_checksum != stored.reference_checksum)
    done.warnings.push_back(en::say(
        "The finger's reference has changed since its calibration: this is a new calibration."));
  if (inputs.finger_checksum != stored.finger_checksum)
    done.warnings.push_back(
        en::say("The finger's camera, face or markers have changed since its calibration: this is "
                "a new calibration."));
  if (inputs.program_version != stored.program_version)
    done.warnings.push_back(en::say(
        "The finger was calibrated by version {}: this is a new calibration, by version {}.",
        stored.program_version, inputs.program_version));
  inputs.date = same_but_for_date(inputs, stored) ? stored.date : now;
}

/// Bodies from outside the finger's folder, to be written into it; the notes name these copies.
Result<std::vector<ReportFile>> copies_of_bodies(const fs::path& folder, PressSet& press_set) {
  std::map<std::string, std::string> copies;  // content by name
  for (auto& [press, note] : press_set.notes) {
    if (!note.body || note.excluded) continue;
    const fs::path file = body_file(folder, *note.body);
    if (file.parent_path() == folder / kBodyFolder) {
      note.body = (fs::path(kBodyFolder) / file.filename()).string();
      continue;
    }
    auto content = read_file(file, kMaxMeshBytes);
    if (!content) return content.error();
    // Another body may have that name already.
    for (int number = 1;; ++number) {
      const std::string mark = number > 1 ? fmt::format("-{}", number) : "";
      const std::string name =
          (fs::path(kBodyFolder) / file.stem()).string() + mark + file.extension().string();
      const auto other = copies.find(name);
      const auto stored =
          other != copies.end() ? Result(other->second) : read_file(folder / name, kMaxMeshBytes);
      std::error_code failed;
      if (stored ? *stored != *content : fs::exists(folder / name, failed)) continue;
      note.body = name;
      if (!stored) copies[name] = std::move(*content);
      break;
    }
  }
  std::vector<ReportFile> files;
  for (auto& [name, content] : copies) files.push_back({name, std::move(content)});
  return files;
}

/// Writes all files at once: until then the finger is unchanged.
Status write(const CalibrationWork& work, FingerCalibration& done, const Job& job) {
  settle_finger(work, done);
  auto bodies = copies_of_bodies(work.store->folder(), done.inputs.press_set);
  if (!bodies) return bodies.error();
  for (BodyFit& body : done.calibration.bodies)  // a copy may have another name
    body.body = fs::path(*done.inputs.press_set.of(body.press).body).filename().string();
  sign_inputs(work, done);
  record(done);
  std::vector<ReportFile> files = std::move(bodies).value();
  const bool has_bodies = !files.empty();
  files.push_back({CalibrationInputs::kFileName, done.inputs.to_yaml()});
  files.push_back({kCalibrationFile, calibration_yaml(done)});
  files.push_back({kReportJson, calibration_report_json(done)});
  bool has_pages = false;
  if (work.make_report && !job.stop_requested()) {
    job.report(0.95, en::say("writing the report"));
    auto reports = work.make_report(done, job);
    // A stop request, or a lack of memory, must still save the calibration, without its reports.
    if (!reports && !job.stop_requested())
      done.warnings.push_back(en::say("The report has no pages: {}.", reports.error().message()));
    has_pages = reports.ok();
    if (has_pages) files.insert(files.end(), reports->begin(), reports->end());
  }
  auto change = FolderChange::begin(work.store->folder());
  if (!change) return change.error();
  if (work.untouched) {
    const auto known = install_flat_reference(*work.untouched, change->staged(), done.finger);
    if (!known) return known.error();
  }
  if (!work.stored)
    for (const FramePtr& frame : work.frames)
      if (const Status status = store_press(change->staged(), *frame); !status) return status;
  // Where presses are being collected this file holds their current notes; elsewhere the inputs do.
  std::error_code absent;
  if (fs::exists(work.store->folder() / PressSet::kFileName, absent))
    files.push_back({PressSet::kFileName, done.inputs.press_set.to_yaml()});
  if (has_bodies)
    if (const Status made = make_folder(change->staged() / kBodyFolder); !made) return made;
  for (const ReportFile& file : files) {
    const Status status = write_file_atomically(change->staged() / file.name, file.content);
    if (!status) return status;
  }
  if (!has_pages)  // nor those about another solution
    for (const char* page : {kReportHtml, kReportPdf}) change->remove(page);
  auto saved = work.store->update([&](Finger& now) -> Status {
    if (finger_checksum(now) != done.inputs.finger_checksum)
      return Error{en::say("its camera, face or markers were changed while it was calibrated"),
                   work.store->folder() / Finger::kFileName, en::say("calibrating again")};
    take_calibration(done.finger, now);
    if (work.untouched) take_reference(done.finger, now);
    return commit_with(now, *change);
  });
  if (!saved) return saved.error();
  done.finger = (*saved)->finger;
  return {};
}

Result<FingerCalibration> run(CalibrationWork work, CalibrationInputs inputs, const Job& job) {
  FingerCalibration done;
  done.inputs = std::move(inputs);
  if (const auto there = work.store->snapshot(); !there) return there.error();
  const auto lock = work.store->lock_for_work("calibrating");
  if (!lock) return lock.error();
  const auto finger = work.store->snapshot();
  if (!finger) return finger.error();
  done.finger = (*finger)->finger;
  done.warnings = (*finger)->warnings;
  if (work.untouched && done.finger.face.kind != FaceKind::kFlat) {
    return Error{
        en::say("only a flat sensor has a single untouched image"), work.untouched->origin,
        en::say("leaving --reference out; this finger is compared with its reference recording")};
  }
  constexpr double kMeasured = 0.3, kSolved = 0.95;  // parts of the time, roughly
  if (const Status status = take_presses(work, done, Job(job, 0, kMeasured)); !status)
    return status.error();
  MeasureAsPaper as_paper;
  if (work.compare_methods)
    as_paper = [&](const Job& section) { return take_presses_as_paper(work, done, section); };
  if (const Status status =
          solve_presses(done, as_paper, Job(job, kMeasured, kSolved), work.on_round);
      !status) {
    if (job.stop_requested()) return status.error();
    Error refused = status.error();
    const fs::path image = leave_press_problem(work.store->folder(), done, refused.what.english());
    if (!image.empty())
      refused.advice = en::clauses({refused.advice, en::say("{} shows what was found", image)});
    return refused;
  }
  if (work.discard_if_stopped && job.stop_requested())
    return Error{en::say("stopped; the finger is unchanged"), "", ""};
  if (const Status status = write(work, done, job); !status) return status.error();
  done.problem_image = leave_press_problem(work.store->folder(), done, "");
  job.report(1.0, en::say("done"));
  return done;
}

}  // namespace

void take_calibration(const Finger& from, Finger& finger) {
  finger.mapping = from.mapping;
  finger.mapping_record = from.mapping_record;
  for (const char* key : {"calibration_date", "calibration_inputs", "calibration_version",
                          "operator", "ball_radius_mm", kPressSettings})
    copy_provenance(from, key, finger);
}

Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input, const Job& job) {
  CalibrationWork work;
  work.store = FingerStore::of(input.folder);
  work.presses = input.presses;
  if (input.reference) {
    auto untouched = read_untouched_image(*input.reference);
    if (!untouched) return untouched.error();
    work.untouched = std::move(untouched).value();
  }
  work.make_report = input.make_report;
  work.compare_methods = input.compare_methods;
  work.discard_if_stopped = input.discard_if_stopped;
  work.on_round = input.on_round;
  CalibrationInputs inputs;
  inputs.program_version = input.program_version;
  inputs.press_set = input.press_set;
  inputs.calibration = input.calibration;
  inputs.pipeline = input.pipeline;
  inputs.date = input.date;
  return run(std::move(work), std::move(inputs), job);
}

Result<FingerCalibration> calibrate_finger_again(const fs::path& folder, CalibrationInputs inputs,
                                                 const std::string& program_version,
                                                 const MakeReport& make_report,
                                                 bool compare_methods, const Job& job) {
  auto stored = CalibrationInputs::load(folder);
  if (!stored) return stored.error();
  CalibrationWork work;
  work.store = FingerStore::of(folder);
  work.make_report = make_report;
  work.compare_methods = compare_methods;
  for (const StoredPress& press : stored->presses)
    work.presses.files.push_back(stored_press_file(folder, press.name));
  work.stored = std::move(stored).value();
  inputs.program_version = program_version;
  return run(std::move(work), std::move(inputs), job);
}

}  // namespace alltact
