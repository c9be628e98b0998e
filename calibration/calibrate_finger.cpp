#include "calibration/calibrate_finger.h"

#include "calibration/reference_recording.h"
#include "calibration/settings_record.h"
#include "core/io/atomic_file.h"
#include "core/io/picture.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <chrono>
#include <ctime>
#include <set>

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

struct TakenPress {
  FramePtr frame;
  std::optional<Press> press;
  std::string problem;  ///< why there is no press
};

Result<Pipeline> make_pipeline(const FingerCalibrationInput& input,
                               const Finger& finger,
                               const Job& job) {
  Finger blank = finger;  // the old mapping must not matter
  blank.mapping.reset();
  if (!input.reference) return Pipeline::create(input.folder, blank, input.pipeline, job);
  const auto picture = read_grey_picture(*input.reference);
  if (!picture) return picture.error();
  const auto grey =
      oriented_for(finger.camera,
                   *picture,
                   "the reference picture",
                   input.reference->string(),
                   "the untouched picture of this sensor, at the size of its presses");
  if (!grey) return grey.error();
  auto library = ReferenceLibrary::single(*grey);
  if (!library) return library.error();
  return Pipeline::create(blank, std::move(library).value(), input.pipeline);
}

Result<std::vector<TakenPress>> take_presses(const FingerCalibrationInput& input,
                                             Pipeline& pipeline,
                                             const Job& job) {
  auto source = open_source(input.presses);
  if (!source) return source.error();
  const double count = static_cast<double>((*source)->count().value_or(0));
  std::vector<TakenPress> taken;
  std::set<std::string> names;
  while (true) {
    if (job.stop_requested()) return Error{"stopped before the calibration was done", "", ""};
    auto frame = (*source)->next();
    if (!frame) return frame.error();
    if (!*frame) break;
    const std::string name = (*frame)->name;
    if (!names.insert(name).second) {
      return Error{fmt::format("two presses are called '{}'", name),
                   (*frame)->origin,
                   "giving the pictures different names; they are kept by name with the finger"};
    }
    if (count > 0) job.report(0.5 * static_cast<double>(taken.size()) / count, "reading " + name);
    if (!(*source)->is_continuous()) pipeline.forget();
    auto result = pipeline(*frame);
    if (!result) return result.error();
    TakenPress press{*frame, std::nullopt, ""};
    if (result->difference && result->shape) {
      press.press = Press{name, std::move(*result->difference), std::move(*result->shape)};
    } else {
      press.problem = result->problems.empty() ? "no face was found" : result->problems.front();
    }
    taken.push_back(std::move(press));
  }
  return taken;
}

Json report_of(const FingerCalibration& done, double ball_radius_mm) {
  const Calibration& calibration = done.calibration;
  Json report;
  report["ball_radius_mm"] = ball_radius_mm;
  report["verdict"] = done.verdict.sentence;
  report["residual_mm"] = calibration.residual_mm;
  if (calibration.held_out_mm > 0) report["held_out_mm"] = calibration.held_out_mm;
  report["condition"] = calibration.condition;
  report["degree_choice"] = calibration.degree_choice;
  Json presses = Json::array();
  for (const BallFit& ball : calibration.balls) {
    Json entry;
    entry["press"] = ball.press;
    entry["centre_mm"] = {ball.centre_mm.x(), ball.centre_mm.y(), ball.centre_mm.z()};
    entry["centre_sd_mm"] = {ball.centre_sd_mm.x(), ball.centre_sd_mm.y(), ball.centre_sd_mm.z()};
    entry["depth_mm"] = ball.depth_mm;
    entry["residual_mm"] = ball.residual_mm;
    if (ball.held_out_mm > 0) entry["held_out_mm"] = ball.held_out_mm;
    entry["tangent_arc_deg"] = ball.tangent_arc_deg;
    entry["cut_by_edge"] = ball.cut_by_edge;
    presses.push_back(std::move(entry));
  }
  report["presses"] = std::move(presses);
  report["left_out"] = calibration.left_out;
  report["remarks"] = calibration.remarks;
  return report;
}

/// What a person can see in the figures but a table of residuals does not say.
void add_remarks(Calibration& calibration) {
  for (const BallFit& ball : calibration.balls) {
    if (calibration.balls.size() > 2 && ball.residual_mm > 3 * calibration.residual_mm) {
      calibration.remarks.push_back(fmt::format(
          "{}: {:.3f} mm, more than three times the others; look at the picture, or leave it out",
          ball.press,
          ball.residual_mm));
    }
  }
}

void record(const FingerCalibrationInput& input, FingerCalibration& done) {
  Finger& finger = done.finger;
  const Calibration& calibration = done.calibration;
  finger.mapping = calibration.mapping;
  MappingRecord record;
  record.method = input.calibration.method == CalibrationMethod::kPaper ? "paper" : "joint";
  for (const BallFit& ball : calibration.balls) record.presses.push_back(ball.press);
  record.residual_mm = calibration.residual_mm;
  record.held_out_mm = calibration.held_out_mm;
  record.degree_choice = calibration.degree_choice;
  finger.mapping_record = std::move(record);
  finger.provenance["calibration_date"] = utc_now();
  finger.provenance["calibration_version"] = input.program_version;
  if (!input.operator_name.empty()) finger.provenance["operator"] = input.operator_name;
  finger.provenance["ball_radius_mm"] = fmt::format("{}", input.ball_radius_mm);
}

Status write(const FingerCalibrationInput& input,
             const std::vector<TakenPress>& taken,
             FingerCalibration& done) {
  // The presses before these do not matter any more, not to a new reference either.
  [[maybe_unused]] const auto none =
      record_settings(SettingsSeen(), RecordingKind::kPresses, done.finger);
  if (input.reference) {
    const auto warnings = install_flat_reference(*input.reference, input.folder, done.finger);
    if (!warnings) return warnings.error();
    done.warnings.insert(done.warnings.end(), warnings->begin(), warnings->end());
  }
  SettingsSeen settings;
  for (const TakenPress& press : taken) settings.add(*press.frame);
  const auto warnings = record_settings(settings, RecordingKind::kPresses, done.finger);
  done.warnings.insert(done.warnings.end(), warnings.begin(), warnings.end());
  const fs::path kept = input.folder / "presses";
  if (const Status status = make_folder(kept); !status) return status;
  for (const TakenPress& press : taken) {
    const Frame& frame = *press.frame;
    const Status status = write_picture(
        kept / (frame.name + ".png"), frame.grey, frame.controls ? *frame.controls : std::string());
    if (!status) return status;
  }
  const Status status = write_file_atomically(input.folder / "calibration_report.json",
                                              report_of(done, input.ball_radius_mm).dump(2) + "\n");
  if (!status) return status;
  return done.finger.save(input.folder);
}

}  // namespace

std::string utc_now() {
  const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(now));
}

Result<FingerCalibration> calibrate_finger(const FingerCalibrationInput& input, const Job& job) {
  FingerCalibration done;
  auto finger = Finger::load(input.folder, &done.warnings);
  if (!finger) return finger.error();
  done.finger = std::move(finger).value();
  if (input.reference && done.finger.face.kind != FaceKind::kFlat) {
    return Error{"only a flat sensor has one untouched picture",
                 input.reference->string(),
                 "leaving --reference out; this finger is compared with its reference recording"};
  }
  auto pipeline = make_pipeline(input, done.finger, job);
  if (!pipeline) return pipeline.error();
  auto taken = take_presses(input, *pipeline, job);
  if (!taken) return taken.error();

  std::vector<Press> presses;
  std::vector<std::string> left_out;
  for (const TakenPress& one : *taken) {
    if (one.press) {
      presses.push_back(*one.press);
    } else {
      left_out.push_back(one.frame->name + ": " + one.problem);
    }
  }
  if (presses.empty()) {
    return Error{"no press can be used; " + fmt::format("{}", fmt::join(left_out, "; ")),
                 "",
                 "pictures of this finger with a ball pressed into its face"};
  }
  job.report(0.5, "solving");
  const auto camera = Camera::create(done.finger.camera);
  if (!camera) return camera.error();
  auto calibration =
      calibrate(presses, *camera, done.finger.face, input.ball_radius_mm, input.calibration, job);
  if (!calibration) return calibration.error();
  done.calibration = std::move(calibration).value();
  auto& all_left_out = done.calibration.left_out;
  all_left_out.insert(all_left_out.begin(), left_out.begin(), left_out.end());
  add_remarks(done.calibration);
  done.verdict = verdict(done.calibration.residual_mm,
                         done.calibration.held_out_mm,
                         static_cast<int>(done.calibration.balls.size()));
  record(input, done);
  if (const Status status = write(input, *taken, done); !status) return status.error();
  job.report(1.0, "done");
  return done;
}

}  // namespace alltact
