#include "calibration/calibration_report.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

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
  const auto place =
      std::find_if(residuals.begin(), residuals.end(), [&](const PressResiduals& one) {
        return one.press == ball.press;
      });
  if (place != residuals.end()) {
    entry["along_mm"] = place->along_mm;
    entry["across_mm"] = place->across_mm;
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
      entry["failed"] = row.failed;
    }
    rows.push_back(std::move(entry));
  }
  return rows;
}

}  // namespace

std::string calibration_report_json(const FingerCalibration& done) {
  const Calibration& calibration = done.calibration;
  Json report;
  report["format"] = "alltact-calibration-report/1";
  report["program_version"] = done.inputs.program_version;
  report["ball_radius_mm"] = done.inputs.ball_radius_mm;
  report["verdict"] = done.verdict.sentence;
  report["residual_mm"] = calibration.residual_mm;
  if (calibration.held_out_mm > 0) report["held_out_mm"] = calibration.held_out_mm;
  Json zones = Json::array();
  for (const ZoneError& zone : done.zones) {
    Json entry{{"zone", zone.zone}, {"presses", zone.presses}};
    if (zone.error_mm) entry["error_mm"] = *zone.error_mm;
    zones.push_back(std::move(entry));
  }
  report["zones"] = std::move(zones);
  if (calibration.spread_mm > 0) report["spread_mm"] = calibration.spread_mm;
  report["expected_error_mm"] = done.verdict.error_mm;
  if (!done.methods.empty()) report["methods"] = methods_json(done.methods);
  report["condition"] = calibration.condition;
  report["degree_choice"] = calibration.degree_choice;
  Json presses = Json::array();
  for (const BallFit& ball : calibration.balls) presses.push_back(press_json(ball, done.residuals));
  report["presses"] = std::move(presses);
  Json excluded = Json::array();
  for (const ExcludedPress& press : done.inputs.excluded)
    excluded.push_back({{"press", press.name}, {"because", press.because}});
  report["excluded"] = std::move(excluded);
  report["left_out"] = calibration.left_out;
  report["fault_signs"] = done.fault_signs;
  report["remarks"] = calibration.remarks;
  // A file name may be anything but UTF-8.
  return report.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string repeat_command(const std::filesystem::path& finger_folder) {
  std::error_code failed;
  std::filesystem::path whole = std::filesystem::weakly_canonical(finger_folder, failed);
  if (failed) whole = finger_folder;
  if (whole.filename().empty()) whole = whole.parent_path();  // it ended in a slash
  return "alltact calibrate " + shell_quoted(whole.filename().string()) + " --again";
}

}  // namespace alltact
