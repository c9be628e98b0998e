#include "calibration/finger/calibration_report.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/presses/press_note_kinds.h"
#include "calibration/report/press_resolution.h"
#include "core/base/atomic_file.h"
#include "core/base/message_json.h"
#include "core/base/utc_time.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
#include "core/recording/matroska.h"
#include "core/recording/video_file.h"
#include "core/sensing/reference/marker_table.h"
#include "core/sensing/reference/reference_library.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

Json english(const std::vector<Message>& messages) {
  Json all = Json::array();
  for (const Message& message : messages) all.push_back(message.english());
  return all;
}

Json press_json(const BallFit& ball, const std::vector<PressResiduals>& residuals) {
  Json entry;
  entry["press"] = ball.press;
  entry["ball_radius_mm"] = ball.radius_mm;
  entry["centre_mm"] = {ball.centre_mm.x(), ball.centre_mm.y(), ball.centre_mm.z()};
  entry["centre_sd_mm"] = {ball.centre_sd_mm.x(), ball.centre_sd_mm.y(), ball.centre_sd_mm.z()};
  entry["depth_mm"] = ball.depth_mm;
  entry["residual_mm"] = ball.residual_mm;
  if (ball.held_out_mm > 0) entry["held_out_mm"] = ball.held_out_mm;
  entry["tangent_arc_deg"] = ball.tangent_arc_deg;
  entry["cut_by_edge"] = ball.cut_by_edge;
  entry["pressed_in_mm"] = ball.indentation_mm;
  if (ball.given_depth)
    entry["measured_depth"] = {{"mm", ball.given_depth->mm}, {"sd_mm", ball.given_depth->sd_mm}};
  const auto found =
      std::find_if(residuals.begin(), residuals.end(),
                   [&](const PressResiduals& one) { return one.press == ball.press; });
  if (found != residuals.end()) {
    entry["along_mm"] = found->along_mm;
    entry["across_mm"] = found->across_mm;
  }
  return entry;
}

Json methods_json(const std::vector<MethodRow>& methods) {
  Json rows = Json::array();
  for (const MethodRow& row : methods) {
    Json entry{{"method", method_name(row.method)}};
    if (row.failed.empty()) {
      entry["presses"] = row.presses;
      entry["press_depth_mm"] = row.press_depth_mm;
      entry["residual_mm"] = row.residual_mm;
      entry["at_depth_mm"] = row.at_depth_mm;
      entry["joint_depth_mm"] = row.joint_depth_mm;
    } else {
      entry["failed"] = row.failed.english();
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

Json messages_json(const std::vector<Message>& messages) {
  Json all = Json::array();
  for (const Message& message : messages) all.push_back(message_json(message));
  return all;
}

/// Sentences by their templates, for programs that show them in another language.
Json messages_json(const Calibration& calibration) {
  Json sentences;
  sentences["degree_choice"] = message_json(calibration.degree_choice);
  sentences["left_out"] = messages_json(calibration.left_out);
  sentences["remarks"] = messages_json(calibration.remarks);
  if (const auto& next = calibration.next_press)
    sentences["next_press"] = {{"enough", next->enough},
                               {"along_mm", next->along_mm},
                               {"across_mm", next->across_mm},
                               {"depth_mm", next->depth_mm},
                               {"sd_now_mm", next->sd_now_mm},
                               {"sd_then_mm", next->sd_then_mm},
                               {"sentence", message_json(next->sentence)}};
  return sentences;
}

/// Settings that differ from their defaults.
template <class S>
void add_settings(const S& settings, const S& defaults, const std::vector<Setting<S>>& table,
                  std::string* command) {
  for (const Setting<S>& setting : table)
    if (setting.get(settings) != setting.get(defaults))
      *command += fmt::format(" --{} {}", setting.name, shell_quoted(setting.get(settings)));
}

}  // namespace

std::string calibration_report_json(const FingerCalibration& done) {
  const Calibration& calibration = done.calibration;
  Json report;
  report["format"] = "alltact-calibration-report/1";
  report["program_version"] = done.inputs.program_version;
  report["ball_radius_mm"] = done.inputs.press_set.ball_radius_mm;
  report["verdict"] = done.verdict.sentence.english();
  report["grade"] = to_string(done.verdict.grade);
  report["evidence"] = verdict_json(done.verdict);
  report["residual_mm"] = calibration.residual_mm;
  if (calibration.held_out_mm > 0) report["held_out_mm"] = calibration.held_out_mm;
  Json zones = Json::array();
  for (const ZoneError& zone : done.zones) {
    Json entry{{"zone", zone.zone.english()}, {"presses", zone.presses}};
    if (zone.error_mm) entry["error_mm"] = *zone.error_mm;
    zones.push_back(std::move(entry));
  }
  report["zones"] = std::move(zones);
  if (calibration.spread_mm > 0) report["spread_mm"] = calibration.spread_mm;
  if (done.pixel_mm > 0) report["pixel_mm"] = done.pixel_mm;
  report["expected_error_mm"] = done.verdict.error_mm;
  if (done.halo.presses > 0)
    report["beside_contacts"] = {{"near_mm", done.halo.near_mm},
                                 {"far_mm", done.halo.far_mm},
                                 {"beyond_skin_mm", done.halo.excess_mm},
                                 {"beyond_skin_sd_mm", done.halo.excess_sd_mm},
                                 {"is_scattered_light", done.halo.is_seen}};
  if (Json resolution = resolution_json(done); !resolution.is_null())
    report["resolution"] = std::move(resolution);
  if (!done.methods.empty()) report["methods"] = methods_json(done.methods);
  report["condition"] = calibration.condition;
  report["degree_choice"] = calibration.degree_choice.english();
  Json presses = Json::array();
  for (const BallFit& ball : calibration.balls) presses.push_back(press_json(ball, done.residuals));
  report["presses"] = std::move(presses);
  Json steps = Json::array();
  for (const StepFit& step : calibration.steps)
    steps.push_back({{"press", step.press},
                     {"step_mm", step.step_mm},
                     {"reads_mm", step.estimated_mm},
                     {"sd_mm", step.sd_mm}});
  if (!steps.empty()) report["steps"] = std::move(steps);
  Json bodies = Json::array();
  for (const BodyFit& body : calibration.bodies)
    bodies.push_back(
        {{"press", body.press}, {"body", body.body}, {"scale", body.scale}, {"sd", body.sd}});
  if (!bodies.empty()) report["bodies"] = std::move(bodies);
  Json excluded = Json::array();
  for (const auto& [name, note] : done.inputs.press_set.notes)
    if (note.excluded) excluded.push_back({{"press", name}, {"because", *note.excluded}});
  report["excluded"] = std::move(excluded);
  report["left_out"] = english(calibration.left_out);
  report["fault_signs"] = english(done.fault_signs);
  report["remarks"] = english(calibration.remarks);
  report["said"] = messages_json(calibration);
  // A file name may be anything but UTF-8.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string repeat_command(const std::filesystem::path& finger_folder) {
  std::error_code failed;
  std::filesystem::path full_path = std::filesystem::weakly_canonical(finger_folder, failed);
  if (failed) full_path = finger_folder;
  if (full_path.filename().empty()) full_path = full_path.parent_path();  // it ended in a slash
  return "alltact calibrate " + shell_quoted(full_path.filename().string()) + " --again";
}

std::string calibrate_command(const FingerCalibrationInput& input) {
  const auto absolute = [](const std::filesystem::path& path) {
    std::error_code failed;
    const auto full_path = std::filesystem::absolute(path, failed);
    return shell_quoted((failed ? path : full_path).string());
  };
  std::string command = "alltact calibrate " + absolute(input.folder);
  for (const auto& press : input.presses.files) command += ' ' + absolute(press);
  const auto add = [&](const char* flag, const std::string& value) {
    command += fmt::format(" --{} {}", flag, shell_quoted(value));
  };
  if (input.presses.bursts) command += " --bursts";
  add("ball-radius-mm", fmt::format("{}", input.press_set.ball_radius_mm));
  for (const auto& [flag, text] : press_note_flags(input.press_set)) add(flag.c_str(), text);
  if (input.reference) command += " --reference " + absolute(*input.reference);
  add_settings(input.calibration, CalibrationSettings{}, calibration_settings(), &command);
  add_settings(input.pipeline, PipelineSettings{}, pipeline_settings(), &command);
  if (!input.press_set.operator_name.empty()) add("operator", input.press_set.operator_name);
  if (!input.date.empty()) add("date", input.date);
  if (input.compare_methods) command += " --compare";
  return command;
}

namespace {

namespace fs = std::filesystem;

bool has_content(const fs::path& file) {
  std::error_code failed;
  return fs::is_regular_file(file, failed) && fs::file_size(file, failed) > 0;
}

/// Size and time of a file, from its folder entry.
std::string stamp_of(const fs::path& file) {
  std::error_code failed;
  const auto size = fs::file_size(file, failed);
  const auto written = fs::last_write_time(file, failed);
  return failed ? file.string() + " absent"
                : fmt::format("{} {} {}", file.string(), size, written.time_since_epoch().count());
}

ReferenceState recording_state(const FingerSnapshot& snapshot) {
  const ReferenceFiles& files = *snapshot.finger.reference;
  const fs::path video = snapshot.folder / files.video, markers = snapshot.folder / files.markers;
  std::error_code failed;
  if (!fs::exists(video, failed) || !fs::exists(markers, failed)) return ReferenceState::kMissing;
  if (!has_content(video) || !has_content(markers)) return ReferenceState::kCut;
  // Opening would repair a recording that a crash truncated: its structure is checked first.
  if (const auto index = index_matroska(video);
      index && (!index->has_length || !index->is_walkable || index->blocks.empty()))
    return ReferenceState::kCut;
  const auto table = MarkerTable::load(markers, snapshot.finger.marker_count());
  if (!table || table->frames.empty()) return ReferenceState::kCut;
  auto recording = VideoFile::open(video);
  if (!recording ||
      static_cast<std::size_t>(std::max(0, table->frames.back())) >= recording->frame_count())
    return ReferenceState::kCut;
  const auto frame = recording->frame(0);
  if (!frame || (*frame)->grey.empty()) return ReferenceState::kCut;
  const auto image = image_for(snapshot, (*frame)->grey, "", video.string(), "");
  return image ? ReferenceState::kIntact : ReferenceState::kOtherImage;
}

ReferenceState image_state(const FingerSnapshot& snapshot) {
  const fs::path image = snapshot.folder / snapshot.finger.reference->image;
  std::error_code failed;
  if (!fs::exists(image, failed)) return ReferenceState::kMissing;
  if (!read_grey_image(image)) return ReferenceState::kCut;
  return flat_reference(snapshot) ? ReferenceState::kIntact : ReferenceState::kOtherImage;
}

}  // namespace

std::optional<double> days_between(const std::string& then, const std::string& now) {
  constexpr double kDay_s = 86400;
  const auto then_s = unix_seconds(then), now_s = unix_seconds(now);
  if (!then_s || !now_s) return std::nullopt;
  return (*now_s - *then_s) / kDay_s;
}

ReferenceState reference_state(const FingerSnapshot& snapshot) {
  const auto& reference = snapshot.finger.reference;
  if (!reference) return ReferenceState::kAbsent;
  std::string key =
      fmt::format("{} {} {}", snapshot.reduced_by, camera_fingerprint(snapshot.finger.camera),
                  snapshot.finger.marker_count());
  for (const std::string& name : {reference->image, reference->video, reference->markers})
    if (!name.empty()) key += '\n' + stamp_of(snapshot.folder / name);
  // States by the files: requested at every refresh of a window.
  static std::mutex mutex;
  static std::map<std::string, ReferenceState> states;
  {
    const std::lock_guard lock(mutex);
    if (const auto known = states.find(key); known != states.end()) return known->second;
  }
  const ReferenceState state =
      reference->image.empty() ? recording_state(snapshot) : image_state(snapshot);
  constexpr std::size_t kMaxStates = 1000;
  const std::lock_guard lock(mutex);
  if (states.size() >= kMaxStates) states.clear();
  return states[key] = state;
}

CalibrationEvidence evidence_in(const FingerSnapshot& snapshot, const std::string& now,
                                const std::string& passed) {
  Finger finger = snapshot.finger;
  if (snapshot.reduced_by > 1) finger.camera = snapshot.full_camera;
  CalibrationEvidence evidence = evidence_of(finger);
  evidence.reference = reference_state(snapshot);
  evidence.repeat_command = Message::typed(repeat_command(snapshot.folder));
  // The checksum covers fields outside the record: markers, and files of earlier versions.
  if (evidence.changed.empty() && finger.mapping_record)
    if (const auto inputs = CalibrationInputs::load(snapshot.folder);
        inputs && !inputs->finger_checksum.empty() &&
        inputs->finger_checksum != finger_checksum(finger))
      evidence.changed.push_back(en::say("camera, face or markers"));
  for (const std::string& time : {provenance_of(snapshot.finger, "calibration_date"), passed})
    if (const auto days = days_between(time, now))
      evidence.days_unchecked = std::min(*days, evidence.days_unchecked.value_or(*days));
  return evidence;
}

nlohmann::ordered_json verdict_json(const Verdict& verdict) {
  nlohmann::ordered_json json;
  json["grade"] = to_string(verdict.grade);
  json["expected_error_mm"] = nullptr;
  if (std::isfinite(verdict.error_mm)) json["expected_error_mm"] = verdict.error_mm;
  json["causes_mm"] = nlohmann::ordered_json::object();
  for (const ErrorPart& part : verdict.parts)
    json["causes_mm"][std::string(to_string(part.cause))] = part.error_mm;
  json["missing"] = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < verdict.missing.size(); ++i)
    json["missing"].push_back(
        {{"evidence", verdict.missing_names[i]}, {"sentence", verdict.missing[i].english()}});
  json["rests_on"] = verdict.rests_on.english();
  json["sentence"] = verdict.sentence.english();
  return json;
}

nlohmann::ordered_json resolution_json(const FingerCalibration& done) {
  const auto worst = worst_resolution(done.residuals);
  if (!worst) return nullptr;
  const auto add_figures = [](const DepthResolution& depth, nlohmann::ordered_json* json) {
    (*json)["two_points_mm"] = depth.two_points_mm;
    (*json)["wall_mm"] = depth.wall_mm;
    (*json)["pin_mm"] = depth.pin_mm;
    (*json)["step_mm"] = depth.step_mm;
  };
  nlohmann::ordered_json json;
  add_figures(*worst, &json);
  for (int i = 0; i < DepthResolution::kWaves; ++i)
    json["waves_per_mm"].push_back(DepthResolution::wave_per_mm(i));
  json["contrasts"] = worst->contrasts;
  for (const PressResiduals& one : done.residuals) {
    if (!one.resolution) continue;
    nlohmann::ordered_json press{
        {"press", one.press}, {"along_mm", one.along_mm}, {"across_mm", one.across_mm}};
    add_figures(*one.resolution, &press);
    json["presses"].push_back(std::move(press));
  }
  json["sentence"] = resolution_sentence(done.residuals, done.halo).english();
  return json;
}

}  // namespace alltact
