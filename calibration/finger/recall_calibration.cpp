#include "calibration/finger/recall_calibration.h"

#include "calibration/finger/calibration_report.h"
#include "calibration/finger/finger_evidence.h"
#include "calibration/finger/take_presses.h"
#include "core/finger/finger_store.h"
#include "core/io/atomic_file.h"
#include "core/io/message_json.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace alltact {
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
    calibration.steps.push_back({word_at(one, "press"),
                                 number_at(one, "step_mm"),
                                 number_at(one, "reads_mm"),
                                 number_at(one, "sd_mm")});
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
    return Error{en::say("the finger is not calibrated"),
                 (folder / Finger::kFileName).string(),
                 en::say("calibrating it with ball presses")};
  auto inputs = CalibrationInputs::load(folder);
  if (!inputs) return inputs.error();
  recalled.inputs = std::move(*inputs);
  const fs::path file = folder / kReportJson;
  const auto content = read_file(file, kLongestReport);
  if (!content) return content.error();
  const Json report = Json::parse(*content, nullptr, false);
  if (!report.is_object() || !is_of(report, *record))
    return Error{en::say("this is not the report of the finger's calibration"),
                 file.string(),
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

Result<FingerCalibration> recall_residuals(const fs::path& folder,
                                           FingerCalibration recalled,
                                           const Job& job) {
  CalibrationWork work;
  work.store = FingerStore::of(folder);
  work.is_repetition = true;
  work.stored = recalled.inputs;
  for (const StoredPress& press : work.stored.presses)
    work.presses.files.push_back(folder / kPressFolder / (press.name + ".png"));
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

}  // namespace alltact
