#include "calibration/finger/calibrate_finger.h"

#include "calibration/finger/calibration_report.h"
#include "calibration/finger/press_problem.h"
#include "calibration/presses/held_frames.h"
#include "calibration/reference/reference_recording.h"
#include "calibration/reference/settings_record.h"
#include "calibration/report/contact_error.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/sensing/pipeline.h"
#include "core/sources/open/open_source.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <ctime>
#include <set>

#include <fmt/chrono.h>
#include <fmt/format.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;

/// One calibration on its way, first or again.
struct Work {
  fs::path folder;
  std::vector<fs::path> pictures;     ///< what open_source is given
  bool bursts = false;                ///< one press each
  std::optional<fs::path> reference;  ///< flat sensors: to be installed
  bool is_repetition = false;         ///< of `inputs`, whose presses these are to be
  CalibrationInputs kept;             ///< what is repeated, as it was stored
  MakeReport make_report;
  std::vector<FramePtr> frames;                      ///< one a press, as they are to be kept
  std::vector<std::optional<Reference>> references;  ///< what each was compared with
};

constexpr std::array kReportPages{"calibration_report.html", "calibration_report.pdf"};

Error stopped() {
  return {"stopped before the calibration was done", "", ""};
}

Result<Pipeline> make_pipeline(const Work& work, const FingerCalibration& done, const Job& job) {
  Finger blank = done.finger;  // the old mapping must not matter
  blank.mapping.reset();
  if (!work.reference) return Pipeline::create(work.folder, blank, done.inputs.pipeline, job);
  const auto picture = read_grey_picture(*work.reference);
  if (!picture) return picture.error();
  const auto grey =
      oriented_for(blank.camera,
                   *picture,
                   "the reference picture",
                   work.reference->string(),
                   "the untouched picture of this sensor, at the size of its presses");
  if (!grey) return grey.error();
  auto library = ReferenceLibrary::single(*grey);
  if (!library) return library.error();
  return Pipeline::create(blank, std::move(library).value(), done.inputs.pipeline);
}

/// The picture that was kept must be the one that was calibrated with.
Status check_kept(const Work& work, const Frame& frame, std::size_t index) {
  if (!work.is_repetition) return {};
  const KeptPress& kept = work.kept.presses[index];
  if (frame.name == kept.name && picture_checksum(frame.grey) == kept.checksum) return {};
  return Error{"this is not the picture that the finger was calibrated with",
               work.pictures[index].string(),
               "calibrating anew with the pictures that are there"};
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
    press.left_out = result.problems.empty() ? "no face was found" : result.problems.front();
  }
  if (const ExcludedPress* excluded = said_of(inputs.excluded, frame.name))
    press.left_out =
        "excluded" + (excluded->because.empty() ? std::string() : ", " + excluded->because);
  return press;
}

Result<std::unique_ptr<Source>> open_presses(const Work& work) {
  if (work.bursts) return std::unique_ptr<Source>(std::make_unique<BurstSource>(work.pictures));
  auto source = open_source(work.pictures);
  if (source || std::none_of(work.pictures.begin(), work.pictures.end(), is_video)) return source;
  Error several = source.error();
  several.advice += ", or --bursts where each video shows one press held still";
  return several;
}

Status take_presses(Work& work, Pipeline& pipeline, FingerCalibration& done, const Job& job) {
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
      return Error{fmt::format("two presses are called '{}'", frame->name),
                   frame->origin,
                   "giving the pictures different names; they are kept by name with the finger"};
    if (const Status status = check_kept(work, *frame, work.frames.size()); !status) return status;
    if (count > 0)
      job.report(0.5 * static_cast<double>(names.size() - 1) / count, "reading " + frame->name);
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
      return Error{fmt::format("no press is called '{}'", name),
                   "",
                   fmt::format("one of {}", fmt::join(names, ", "))};
  return {};
}

/// What a person can see in the figures but a table of residuals does not say.
void add_remarks(Calibration& calibration) {
  if (calibration.weakness) calibration.remarks.push_back(calibration.weakness->sentence);
  if (calibration.radius_sense) calibration.remarks.push_back(calibration.radius_sense->sentence);
  if (calibration.next_press) calibration.remarks.push_back(calibration.next_press->sentence);
  for (const BallFit& ball : calibration.balls) {
    if (calibration.balls.size() > 2 && ball.residual_mm > 3 * calibration.residual_mm) {
      calibration.remarks.push_back(fmt::format(
          "{}: {:.3f} mm, more than three times the others; look at the picture, or leave it out",
          ball.press,
          ball.residual_mm));
    }
  }
}

/// `references`: what each press was compared with.
Status solve(FingerCalibration& done,
             const std::vector<std::optional<Reference>>& references,
             bool compare,
             const Job& job) {
  std::vector<Press> used;
  std::vector<std::string> left_out;
  for (const TakenPress& one : done.presses) {
    if (one.left_out.empty()) {
      used.push_back(*one.press);
    } else {
      left_out.push_back(one.name + ": " + one.left_out);
    }
  }
  const CalibrationInputs& inputs = done.inputs;
  if (inputs.calibration.method != CalibrationMethod::kJoint &&
      !(inputs.depths.empty() && inputs.steps.empty()))
    return Error{"only the joint method uses measured depths and punches with a step",
                 "",
                 "leaving them out, or --method joint"};
  if (used.empty())
    return Error{"no press can be used; " + fmt::format("{}", fmt::join(left_out, "; ")),
                 "",
                 "pictures of this finger with a ball pressed into its face"};
  job.report(0.5, "solving");
  const auto camera = Camera::create(done.finger.camera);
  if (!camera) return camera.error();
  auto calibration = calibrate(used, *camera, done.finger.face, done.inputs.calibration, job);
  if (!calibration) return calibration.error();
  done.calibration = std::move(calibration).value();
  if (job.stop_requested())
    done.calibration.remarks.emplace_back(
        "stopped before the end: this is the best solution until then, without a report; "
        "calibrating again from what is kept finishes it");
  auto& all_left_out = done.calibration.left_out;
  all_left_out.insert(all_left_out.begin(), left_out.begin(), left_out.end());
  add_remarks(done.calibration);

  std::vector<const Press*> presses;
  for (const Press& press : used)
    if (!press.step_mm) presses.push_back(&press);
  done.residuals = press_residuals(presses, done.finger.face, done.calibration);
  done.zones = zone_errors(done.residuals, done.calibration, done.finger.face.kind);
  std::vector<PressSign> signs;
  for (const TakenPress& press : done.presses)
    if (press.left_out.empty()) signs.push_back(press.sign);
  done.fault_signs = fault_signs(signs);
  std::vector<ComparedPress> compared;
  for (std::size_t i = 0; i < done.presses.size(); ++i)
    if (done.presses[i].left_out.empty() && !done.presses[i].press->step_mm)
      compared.push_back({&*done.presses[i].press, &*references[i]});
  done.pixel_mm = contact_error_mm(compared, done.residuals, done.calibration.mapping);
  done.verdict = verdict({done.calibration.residual_mm,
                          done.calibration.held_out_mm,
                          done.calibration.spread_mm,
                          static_cast<int>(done.calibration.balls.size()),
                          done.pixel_mm});
  if (compare && done.inputs.calibration.method == CalibrationMethod::kJoint &&
      !job.stop_requested()) {
    job.report(0.9, "comparing with other methods");
    done.methods = compare_methods(used, *camera, done.finger.face, done.calibration, job);
  }
  return {};
}

void record(FingerCalibration& done) {
  Finger& finger = done.finger;
  const CalibrationInputs& inputs = done.inputs;
  const Calibration& calibration = done.calibration;
  finger.mapping = calibration.mapping;
  MappingRecord record;
  record.method = method_name(inputs.calibration.method);
  for (const BallFit& ball : calibration.balls) record.presses.push_back(ball.press);
  record.residual_mm = calibration.residual_mm;
  record.held_out_mm = calibration.held_out_mm;
  record.spread_mm = calibration.spread_mm;
  record.pixel_mm = done.pixel_mm;
  record.degree_choice = calibration.degree_choice;
  finger.mapping_record = std::move(record);
  finger.provenance["calibration_date"] = inputs.date;
  finger.provenance["calibration_inputs"] = CalibrationInputs::kFileName;
  finger.provenance["calibration_version"] = inputs.program_version;
  if (!inputs.operator_name.empty()) finger.provenance["operator"] = inputs.operator_name;
  finger.provenance["ball_radius_mm"] = fmt::format("{}", inputs.ball_radius_mm);
}

/// What all was taken with, and which reference it was.
Status settle_finger(const Work& work, FingerCalibration& done) {
  // The presses before these do not matter any more, not to a new reference either.
  [[maybe_unused]] const auto none =
      record_settings(SettingsSeen(), RecordingKind::kPresses, done.finger);
  if (work.reference) {
    Frame frame;
    std::string note;
    const auto grey = read_grey_picture(*work.reference, &note);
    if (!grey) return grey.error();
    if (!note.empty()) frame.controls = std::make_shared<const std::string>(note);
    SettingsSeen settings;
    settings.add(frame);
    done.about_settings = record_settings(settings, RecordingKind::kReference, done.finger);
    done.inputs.reference_checksum = picture_checksum(*grey);
  } else {
    auto checksum = reference_checksum(work.folder, done.finger);
    if (!checksum) return checksum.error();
    done.inputs.reference_checksum = *checksum;
  }
  SettingsSeen settings;
  for (const FramePtr& frame : work.frames) settings.add(*frame);
  const auto warnings = record_settings(settings, RecordingKind::kPresses, done.finger);
  done.about_settings.insert(done.about_settings.end(), warnings.begin(), warnings.end());
  return {};
}

/// Whatever a result depends on that does not stand in the inputs by itself.
void sign_inputs(const Work& work, FingerCalibration& done) {
  CalibrationInputs& inputs = done.inputs;
  inputs.finger_checksum = finger_checksum(done.finger);
  inputs.presses.clear();
  for (const FramePtr& frame : work.frames)
    inputs.presses.push_back({frame->name, picture_checksum(frame->grey)});
  if (work.is_repetition && inputs.reference_checksum != work.kept.reference_checksum)
    done.warnings.emplace_back(
        "The finger has another reference than it was calibrated with: this is a new calibration.");
  if (work.is_repetition && inputs.finger_checksum != work.kept.finger_checksum)
    done.warnings.emplace_back(
        "The finger's camera, face or markers are not what they were when it was calibrated: this "
        "is a new calibration.");
  if (work.is_repetition && inputs.program_version != work.kept.program_version)
    done.warnings.push_back(fmt::format(
        "The finger was calibrated by version {}: this is a new calibration, by version {}.",
        work.kept.program_version,
        inputs.program_version));
  if (work.is_repetition)
    inputs.date = same_but_for_date(inputs, work.kept) ? work.kept.date : utc_now();
  else if (inputs.date.empty())
    inputs.date = utc_now();
}

Status write_presses(const Work& work) {
  if (work.is_repetition) return {};
  const fs::path kept = work.folder / kPressFolder;
  if (const Status status = make_folder(kept); !status) return status;
  for (const FramePtr& frame : work.frames) {
    const Status status = write_picture(kept / (frame->name + ".png"),
                                        frame->grey,
                                        frame->controls ? *frame->controls : std::string());
    if (!status) return status;
  }
  return {};
}

/// finger.yaml last: until then the finger measures as before.
Status write(const Work& work, FingerCalibration& done, const Job& job) {
  if (const Status status = settle_finger(work, done); !status) return status;
  sign_inputs(work, done);
  record(done);
  std::vector<ReportFile> files{{CalibrationInputs::kFileName, done.inputs.to_yaml()},
                                {"calibration_report.json", calibration_report_json(done)}};
  bool has_pages = false;
  if (work.make_report && !job.stop_requested()) {
    job.report(0.95, "writing the report");
    auto reports = work.make_report(done, job);
    // Whoever stops wants what there is, not the pages about it.
    if (!reports && !job.stop_requested()) return reports.error();
    has_pages = reports.ok();
    if (has_pages) files.insert(files.end(), reports->begin(), reports->end());
  }
  if (work.reference) {
    const auto known = install_flat_reference(*work.reference, work.folder, done.finger);
    if (!known) return known.error();
  }
  if (const Status status = write_presses(work); !status) return status;
  for (const ReportFile& file : files) {
    const Status status = write_file_atomically(work.folder / file.name, file.content);
    if (!status) return status;
  }
  if (!has_pages) {  // nor those about another solution
    std::error_code absent;
    for (const char* page : kReportPages) fs::remove(work.folder / page, absent);
  }
  // Typed in while this ran, and no business of it.
  if (const auto now = Finger::load(work.folder))
    done.finger.gripper_from_camera = now->gripper_from_camera;
  return done.finger.save(work.folder);
}

Result<FingerCalibration> run(Work work, CalibrationInputs inputs, const Job& job) {
  FingerCalibration done;
  done.inputs = std::move(inputs);
  auto finger = Finger::load(work.folder, &done.warnings);
  if (!finger) return finger.error();
  done.finger = std::move(finger).value();
  if (work.reference && done.finger.face.kind != FaceKind::kFlat) {
    return Error{"only a flat sensor has one untouched picture",
                 work.reference->string(),
                 "leaving --reference out; this finger is compared with its reference recording"};
  }
  auto pipeline = make_pipeline(work, done, job);
  if (!pipeline) return pipeline.error();
  if (const Status status = take_presses(work, *pipeline, done, job); !status)
    return status.error();
  if (const Status status = check_names(done); !status) return status.error();
  if (const Status status = solve(done, work.references, work.make_report != nullptr, job);
      !status) {
    if (job.stop_requested()) return status.error();
    Error refused = status.error();
    const fs::path picture = leave_press_problem(work.folder, done, refused.what);
    if (!picture.empty())
      refused.advice += fmt::format("; {} shows what was found", picture.string());
    return refused;
  }
  work.references.clear();
  if (const Status status = write(work, done, job); !status) return status.error();
  done.problem_picture = leave_press_problem(work.folder, done, "");
  job.report(1.0, "done");
  return done;
}

}  // namespace

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

bool is_utc(std::string_view text) {
  constexpr std::string_view kForm = "0000-00-00T00:00:00Z";
  return text.size() == kForm.size() &&
         std::equal(text.begin(), text.end(), kForm.begin(), [](char c, char form) {
           return form == '0' ? c >= '0' && c <= '9' : c == form;
         });
}

Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input, const Job& job) {
  Work work;
  work.folder = input.folder;
  work.pictures = input.presses;
  work.bursts = input.bursts;
  work.reference = input.reference;
  work.make_report = input.make_report;
  CalibrationInputs inputs;
  inputs.program_version = input.program_version;
  inputs.operator_name = input.operator_name;
  static_cast<SaidOfPresses&>(inputs) = input;
  inputs.calibration = input.calibration;
  inputs.pipeline = input.pipeline;
  inputs.date = input.date;
  return run(std::move(work), std::move(inputs), job);
}

Result<FingerCalibration> calibrate_finger_again(const fs::path& folder,
                                                 CalibrationInputs inputs,
                                                 const std::string& program_version,
                                                 const MakeReport& make_report,
                                                 const Job& job) {
  auto kept = CalibrationInputs::load(folder);
  if (!kept) return kept.error();
  Work work;
  work.folder = folder;
  work.is_repetition = true;
  work.make_report = make_report;
  for (const KeptPress& press : kept->presses)
    work.pictures.push_back(folder / kPressFolder / (press.name + ".png"));
  work.kept = std::move(kept).value();
  inputs.program_version = program_version;
  return run(std::move(work), std::move(inputs), job);
}

}  // namespace alltact
