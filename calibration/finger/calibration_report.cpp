#include "calibration/finger/calibration_report.h"

#include "calibration/finger/calibrate_presses.h"
#include "calibration/finger/calibration_inputs.h"
#include "calibration/presses/press_note_kinds.h"
#include "core/base/atomic_file.h"
#include "core/base/message_json.h"
#include "core/base/utc_time.h"
#include "core/finger/finger_store.h"
#include "core/image/image_file.h"
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

/// Sentences that recall_calibration() repeats in any language.
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
  return command;
}

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr std::size_t kLongestReport = std::size_t{16} << 20;

/// 0 where there is no such number.
double number_at(const Json& json, const char* key) {
  const auto value = json.find(key);
  if (value == json.end() || !value->is_number()) return 0;
  const double number = value->get<double>();
  return std::isfinite(number) ? number : 0;
}

std::string word_at(const Json& json, const char* key) {
  const auto value = json.find(key);
  return value != json.end() && value->is_string() ? value->get<std::string>() : std::string();
}

Eigen::Vector3d vector_at(const Json& json, const char* key) {
  Eigen::Vector3d position = Eigen::Vector3d::Zero();
  const auto value = json.find(key);
  if (value == json.end() || !value->is_array() || value->size() != 3) return position;
  for (std::size_t i = 0; i < 3; ++i)
    if ((*value)[i].is_number()) position[static_cast<Eigen::Index>(i)] = (*value)[i].get<double>();
  return position;
}

const Json& list_at(const Json& json, const char* key) {
  static const Json kNone = Json::array();
  const auto value = json.find(key);
  return value != json.end() && value->is_array() ? *value : kNone;
}

BallFit ball_of(const Json& json) {
  BallFit ball;
  ball.press = word_at(json, "press");
  ball.radius_mm = number_at(json, "ball_radius_mm");
  ball.centre_mm = vector_at(json, "centre_mm");
  ball.centre_sd_mm = vector_at(json, "centre_sd_mm");
  ball.depth_mm = number_at(json, "depth_mm");
  ball.residual_mm = number_at(json, "residual_mm");
  ball.held_out_mm = number_at(json, "held_out_mm");
  ball.tangent_arc_deg = number_at(json, "tangent_arc_deg");
  const auto cut = json.find("cut_by_edge");
  ball.cut_by_edge = cut != json.end() && cut->is_boolean() && cut->get<bool>();
  ball.indentation_mm = number_at(json, "pressed_in_mm");
  if (const auto depth_json = json.find("measured_depth");
      depth_json != json.end() && depth_json->is_object())
    ball.given_depth = GivenDepth{number_at(*depth_json, "mm"), number_at(*depth_json, "sd_mm")};
  return ball;
}

std::optional<PressAdvice> advice_of(const Json& sentences) {
  const auto json = sentences.find("next_press");
  if (json == sentences.end() || !json->is_object()) return std::nullopt;
  PressAdvice advice;
  const auto enough = json->find("enough");
  advice.enough = enough != json->end() && enough->is_boolean() && enough->get<bool>();
  advice.along_mm = number_at(*json, "along_mm");
  advice.across_mm = number_at(*json, "across_mm");
  advice.depth_mm = number_at(*json, "depth_mm");
  advice.sd_now_mm = number_at(*json, "sd_now_mm");
  advice.sd_then_mm = number_at(*json, "sd_then_mm");
  if (const auto sentence = json->find("sentence"); sentence != json->end())
    advice.sentence = message_of(*sentence);
  return advice;
}

/// The stored templates, so that they can be translated; in English where there are none.
std::vector<Message> messages_of(const Json& report, const Json& sentences, const char* key) {
  std::vector<Message> messages;
  for (const Json& one : list_at(sentences.contains(key) ? sentences : report, key))
    messages.push_back(message_of(one));
  return messages;
}

void read_report(const Json& report, const MappingRecord& record, Calibration& calibration) {
  static const Json kNothing = Json::object();
  const auto there = report.find("said");
  const Json& sentences = there != report.end() && there->is_object() ? *there : kNothing;
  for (const Json& one : list_at(report, "presses")) calibration.balls.push_back(ball_of(one));
  for (const Json& one : list_at(report, "steps"))
    calibration.steps.push_back({word_at(one, "press"), number_at(one, "step_mm"),
                                 number_at(one, "reads_mm"), number_at(one, "sd_mm")});
  calibration.residual_mm = record.residual_mm;
  calibration.held_out_mm = record.held_out_mm;
  calibration.spread_mm = record.spread_mm;
  calibration.condition = number_at(report, "condition");
  calibration.degree_choice = sentences.contains("degree_choice")
                                  ? message_of(sentences["degree_choice"])
                                  : Message::typed(record.degree_choice);
  calibration.left_out = messages_of(report, sentences, "left_out");
  calibration.remarks = messages_of(report, sentences, "remarks");
  calibration.next_press = advice_of(sentences);
}

bool is_of(const Json& report, const MappingRecord& record) {
  const Json& presses = list_at(report, "presses");
  if (presses.size() != record.presses.size()) return false;
  for (std::size_t i = 0; i < presses.size(); ++i)
    if (word_at(presses[i], "press") != record.presses[i]) return false;
  return std::abs(number_at(report, "residual_mm") - record.residual_mm) <= 1e-9;
}

}  // namespace

Result<FingerCalibration> recall_calibration(const fs::path& folder) {
  const auto finger = open_finger(folder);
  if (!finger) return finger.error();
  FingerCalibration recalled;
  recalled.finger = (*finger)->finger;
  const auto& record = recalled.finger.mapping_record;
  if (!recalled.finger.mapping || !record)
    return Error{en::say("the finger is not calibrated"), (folder / Finger::kFileName).string(),
                 en::say("calibrating it with ball presses")};
  auto inputs = CalibrationInputs::load(folder);
  if (!inputs) return inputs.error();
  recalled.inputs = std::move(*inputs);
  const fs::path file = folder / kReportJson;
  const auto content = read_file(file, kLongestReport);
  if (!content) return content.error();
  const Json report = Json::parse(*content, nullptr, false);
  if (!report.is_object() || !is_of(report, *record))
    return Error{en::say("this is not the report of the finger's calibration"), file.string(),
                 en::say("calibrating again")};
  read_report(report, *record, recalled.calibration);
  recalled.calibration.mapping = *recalled.finger.mapping;
  recalled.pixel_mm = record->pixel_mm;
  recalled.pixel_sd_mm = record->basis ? record->basis->pixel_sd_mm : 0.0;
  if (record->basis && record->basis->halo_mm > 0) {
    recalled.halo.is_seen = true;
    recalled.halo.excess_mm = record->basis->halo_mm;
  }
  const CalibrationEvidence evidence = evidence_in(**finger, "");
  recalled.contradictions = evidence.contradictions;
  recalled.verdict = verdict(evidence);
  return recalled;
}

Result<FingerCalibration> recall_residuals(const fs::path& folder, FingerCalibration recalled,
                                           const Job& job) {
  CalibrationWork work;
  work.store = FingerStore::of(folder);
  work.stored = recalled.inputs;
  for (const StoredPress& press : work.stored->presses)
    work.presses.files.push_back(stored_press_file(folder, press.name));
  if (const Status taken = take_presses(work, recalled, job); !taken) return taken.error();
  std::vector<const Press*> used;
  std::vector<PressSign> signs;
  for (const TakenPress& one : recalled.presses) {
    if (!one.left_out.empty()) continue;
    if (!one.press->step_mm) used.push_back(&*one.press);
    signs.push_back(one.sign);
  }
  const Face& face = recalled.finger.face;
  recalled.residuals = press_residuals(used, face, recalled.calibration);
  recalled.zones = zone_errors(recalled.residuals, recalled.calibration, face.kind);
  recalled.fault_signs = fault_signs(signs);
  recalled.presses.clear();
  return recalled;
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

}  // namespace alltact
