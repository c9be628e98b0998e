#include "calibration/study/study_file.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::json;
constexpr std::array<const char*, kFaceZones> kZoneKeys{"base", "middle", "tip"};

Json settings_json(const PipelineSettings& settings) {
  Json json;
  for (const auto& setting : pipeline_settings()) json[setting.name] = setting.get(settings);
  return json;
}

Json errors_json(const StudyRow& row) {
  Json json{{"frames", row.frames}, {"frames_missing", row.frames_missing}};
  const auto add = [&](const std::string& name, const std::optional<ErrorSpread>& spread) {
    if (!spread) return;
    json[name] = {{"median_mm", spread->median_mm}, {"p95_mm", spread->p95_mm}};
  };
  add("depth", row.depth);
  for (std::size_t zone = 0; zone < kFaceZones; ++zone)
    add(std::string("depth_") + kZoneKeys[zone], row.depth_by_zone[zone]);
  if (row.coverage) json["coverage"] = *row.coverage;
  if (row.false_depth_mm) json["false_depth_mm"] = *row.false_depth_mm;
  if (row.position_mm) json["place_mm"] = *row.position_mm;
  if (row.position_p95_mm) json["place_p95_mm"] = *row.position_p95_mm;
  if (row.angle_deg) json["angle_deg"] = *row.angle_deg;
  if (row.angle_p95_deg) json["angle_p95_deg"] = *row.angle_p95_deg;
  json["bars"] = row.bars;
  json["bars_missing"] = row.bars_missing;
  return json;
}

Json real_json(const RealErrors& real) {
  Json json{{"presses", real.presses}, {"presses_missing", real.presses_missing}};
  json["depth"] = {{"median_mm", real.depth.median_mm}, {"p95_mm", real.depth.p95_mm}};
  for (std::size_t zone = 0; zone < kFaceZones; ++zone)
    if (const auto& spread = real.depth_by_zone[zone])
      json[std::string("depth_") + kZoneKeys[zone]] = {{"median_mm", spread->median_mm},
                                                       {"p95_mm", spread->p95_mm}};
  return json;
}

Json times_json(const StudyRow& row) {
  return {{"median_ms", row.time_ms},
          {"p95_ms", row.time_p95_ms},
          {"ratio", row.time_ratio},
          {"memory_bytes", row.memory_bytes}};
}

std::optional<double> number_at(const Json& json, const char* name) {
  const auto found = json.find(name);
  return found == json.end() ? std::nullopt : std::optional(found->get<double>());
}

std::optional<ErrorSpread> spread_at(const Json& json, const std::string& name) {
  const auto found = json.find(name);
  if (found == json.end()) return std::nullopt;
  return ErrorSpread{found->at("median_mm"), found->at("p95_mm")};
}

RealErrors real_from(const Json& json) {
  RealErrors real;
  real.presses = json.at("presses");
  real.presses_missing = json.at("presses_missing");
  real.depth = spread_at(json, "depth").value_or(ErrorSpread{});
  for (std::size_t zone = 0; zone < kFaceZones; ++zone)
    real.depth_by_zone[zone] = spread_at(json, std::string("depth_") + kZoneKeys[zone]);
  return real;
}

// nullopt: an unknown setting, or a value outside its range.
std::optional<StudyRow> row_from(const Json& json) {
  StudyRow row;
  for (const auto& setting : pipeline_settings()) {
    const auto value = json.at("settings").at(setting.name).get<std::string>();
    if (!setting.set(row.settings, value)) return std::nullopt;
  }
  const Json& errors = json.at("errors");
  row.frames = errors.at("frames");
  row.frames_missing = errors.at("frames_missing");
  row.depth = spread_at(errors, "depth");
  for (std::size_t zone = 0; zone < kFaceZones; ++zone)
    row.depth_by_zone[zone] = spread_at(errors, std::string("depth_") + kZoneKeys[zone]);
  row.coverage = number_at(errors, "coverage");
  row.false_depth_mm = number_at(errors, "false_depth_mm");
  row.position_mm = number_at(errors, "place_mm");
  row.position_p95_mm = number_at(errors, "place_p95_mm");
  row.angle_deg = number_at(errors, "angle_deg");
  row.angle_p95_deg = number_at(errors, "angle_p95_deg");
  row.bars = errors.at("bars");
  row.bars_missing = errors.at("bars_missing");
  if (const auto real = json.find("real"); real != json.end()) row.real = real_from(*real);
  const Json& times = json.at("times");
  row.time_ms = times.at("median_ms");
  row.time_p95_ms = times.at("p95_ms");
  row.time_ratio = times.at("ratio");
  row.memory_bytes = times.at("memory_bytes");
  return row;
}

std::string micrometres(const std::optional<double>& mm) {
  return mm ? fmt::format("{:.1f}", 1000 * *mm) : "-";
}

Json phrases_json(const std::vector<Message>& phrases) {
  Json json = Json::array();
  for (const Message& phrase : phrases) json.push_back(phrase.english());
  return json;
}

std::string text_line(const AccuracyStudy& study, std::size_t number) {
  const StudyRow& row = study.rows[number];
  std::string line = fmt::format(
      "{:>8.2f} {:>8.2f} {:>8.2f}", frame_ms(study, row), frame_p95_ms(study, row), row.time_ratio);
  const auto add = [&](const std::optional<double>& mm) {
    line += fmt::format(" {:>8}", micrometres(mm));
  };
  add(row.depth ? std::optional(row.depth->median_mm) : std::nullopt);
  add(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt);
  for (const auto& zone : row.depth_by_zone)
    add(zone ? std::optional(zone->median_mm) : std::nullopt);
  add(row.false_depth_mm);
  add(row.position_mm);
  line += fmt::format(" {:>8}", row.angle_deg ? fmt::format("{:.2f}", *row.angle_deg) : "-");
  if (study.rows.front().real)
    add(row.real ? std::optional(row.real->depth.median_mm) : std::nullopt);
  return line + "  " + words_of(row.settings, study.rows.front().settings).english();
}

}  // namespace

std::string line_of(const StudyRow& row) {
  Json json{{"settings", settings_json(row.settings)},
            {"errors", errors_json(row)},
            {"times", times_json(row)}};
  if (row.real) json["real"] = real_json(*row.real);
  return json.dump() + "\n";
}

Result<std::vector<StudyRow>> rows_of_lines(std::string_view lines, const std::string& where) {
  std::vector<StudyRow> rows;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) break;  // truncated while it was written
    const Json json = Json::parse(lines.substr(0, end), nullptr, false);
    lines.remove_prefix(end + 1);
    std::optional<StudyRow> row;
    try {
      if (!json.is_discarded()) row = row_from(json);
    } catch (const Json::exception&) {
      row.reset();
    }
    if (!row)
      return Error{en::say("is not what a study of this program keeps"),
                   where,
                   en::say("remove it, and the study begins anew")};
    rows.push_back(std::move(*row));
  }
  return rows;
}

Json json_of(const AccuracyStudy& study) {
  const std::vector<std::size_t> front = pareto_front(study);
  Json json;
  json["about"] = study.about.english();
  json["truth"] = study.simulated ? "simulated" : "painted";
  json["world"] = fmt::format("{:016x}", study.world_checksum);
  json["mapping_p95_mm"] = study.mapping_p95_mm;
  if (const auto limit_mm = default_position_limit_mm(study)) json["place_limit_mm"] = *limit_mm;
  Json& rows = json["rows"] = Json::array();
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    Json entry{{"words", words_of(row.settings, study.rows.front().settings).english()},
               {"settings", settings_json(row.settings)},
               {"errors", errors_json(row)},
               {"times", times_json(row)},
               {"on_front", std::find(front.begin(), front.end(), i) != front.end()}};
    if (row.real) entry["real"] = real_json(*row.real);
    const StudyBalance balance = balance_of(study, row);
    entry["loses"] = phrases_json(balance.loses);
    entry["brings"] = phrases_json(balance.brings);
    entry["proven"] = is_proven(row.settings, study.rows.front().settings);
    if (const auto better = dominated_by(study, front, i))
      entry["dominated_by"] =
          words_of(study.rows[*better].settings, study.rows.front().settings).english();
    rows.push_back(std::move(entry));
  }
  return json;
}

std::string csv_of(const AccuracyStudy& study) {
  std::string csv;
  for (const auto& setting : pipeline_settings()) csv += setting.name + ',';
  csv +=
      "time_ms,time_p95_ms,time_ratio,depth_median_mm,depth_p95_mm,base_median_mm,"
      "middle_median_mm,tip_median_mm,coverage,false_depth_mm,place_mm,place_p95_mm,angle_deg,"
      "angle_p95_deg,memory_bytes,"
      "on_front,real_median_mm,real_p95_mm\n";
  const std::vector<std::size_t> front = pareto_front(study);
  const auto number = [](const std::optional<double>& value) {
    return value ? fmt::format("{}", *value) : "";
  };
  const auto median = [&](const std::optional<ErrorSpread>& spread) {
    return number(spread ? std::optional(spread->median_mm) : std::nullopt);
  };
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const StudyRow& row = study.rows[i];
    const bool is_on_front = std::find(front.begin(), front.end(), i) != front.end();
    for (const auto& setting : pipeline_settings()) csv += setting.get(row.settings) + ',';
    csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n",
                       frame_ms(study, row),
                       frame_p95_ms(study, row),
                       row.time_ratio,
                       median(row.depth),
                       number(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt),
                       median(row.depth_by_zone[0]),
                       median(row.depth_by_zone[1]),
                       median(row.depth_by_zone[2]),
                       number(row.coverage),
                       number(row.false_depth_mm),
                       number(row.position_mm),
                       number(row.position_p95_mm),
                       number(row.angle_deg),
                       number(row.angle_p95_deg),
                       row.memory_bytes,
                       is_on_front ? 1 : 0,
                       number(row.real ? std::optional(row.real->depth.median_mm) : std::nullopt),
                       number(row.real ? std::optional(row.real->depth.p95_mm) : std::nullopt));
  }
  return csv;
}

std::string text_of(const AccuracyStudy& study) {
  const bool has_real = study.rows.front().real.has_value();
  std::string text =
      fmt::format("{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}{}\n",
                  "ms",
                  "95 %",
                  "ratio",
                  "depth",
                  "95 %",
                  "base",
                  "middle",
                  "tip",
                  "false",
                  "place",
                  "angle",
                  has_real ? "     real" : "") +
      fmt::format("{:>26} {}\n",
                  "",
                  has_real ? "errors in micrometres, of angles in degrees; real: of "
                             "presses left out of the calibration"
                           : "errors in micrometres, of angles in degrees");
  text += "Nothing measured is faster and more accurate in depth and in place than these:\n";
  const std::vector<std::size_t> front = pareto_front(study);
  for (const std::size_t row : front) text += text_line(study, row) + '\n';
  text += "As it is, and with one setting changed:\n";
  for (std::size_t i = 0; i < study.rows.size(); ++i) {
    const std::string words =
        words_of(study.rows[i].settings, study.rows.front().settings).english();
    if (words.find(',') != std::string::npos) continue;
    text += text_line(study, i);
    const StudyBalance balance = balance_of(study, study.rows[i]);
    if (!balance.loses.empty())
      text += fmt::format("   (loses: {})", en::list(balance.loses).english());
    if (!is_proven(study.rows[i].settings, study.rows.front().settings))
      text += "   (what it loses is not in these pictures)";
    else if (const auto better = dominated_by(study, front, i))
      text += fmt::format(
          "   (worse than {})",
          words_of(study.rows[*better].settings, study.rows.front().settings).english());
    text += '\n';
  }
  return text;
}

}  // namespace alltact
