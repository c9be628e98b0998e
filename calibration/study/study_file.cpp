#include "calibration/study/study_file.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/study/study_machine.h"
#include "core/base/atomic_file.h"
#include "core/base/utc_time.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <fstream>
#include <set>

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
  std::string line = fmt::format("{:>8.2f} {:>8.2f} {:>8.2f}", frame_ms(study, row),
                                 frame_p95_ms(study, row), row.time_ratio);
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
      return Error{en::say("is not a study file of this program"), where,
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
    csv +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{}\n", frame_ms(study, row),
                    frame_p95_ms(study, row), row.time_ratio, median(row.depth),
                    number(row.depth ? std::optional(row.depth->p95_mm) : std::nullopt),
                    median(row.depth_by_zone[0]), median(row.depth_by_zone[1]),
                    median(row.depth_by_zone[2]), number(row.coverage), number(row.false_depth_mm),
                    number(row.position_mm), number(row.position_p95_mm), number(row.angle_deg),
                    number(row.angle_p95_deg), row.memory_bytes, is_on_front ? 1 : 0,
                    number(row.real ? std::optional(row.real->depth.median_mm) : std::nullopt),
                    number(row.real ? std::optional(row.real->depth.p95_mm) : std::nullopt));
  }
  return csv;
}

std::string text_of(const AccuracyStudy& study) {
  const bool has_real = study.rows.front().real.has_value();
  std::string text =
      fmt::format("{:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8} {:>8}{}\n", "ms",
                  "95 %", "ratio", "depth", "95 %", "base", "middle", "tip", "false", "place",
                  "angle", has_real ? "     real" : "") +
      fmt::format("{:>26} {}\n", "",
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

namespace {

using FileJson = nlohmann::json;
constexpr const char* kStudyFormat = "alltact-finger-study/1";
constexpr int kFingerStudyFrames = 9, kFingerStudyRepeats = 2;
constexpr double kPaintingPart = 0.25;  // of the time of a quick study

/// Subject and origin of a study.
struct StudyHead {
  std::string of, program_version, computer, date, world;
  double mapping_p95_mm = 0;

  [[nodiscard]] std::string line() const {
    return FileJson{{"format", kStudyFormat},
                    {"of", of},
                    {"program_version", program_version},
                    {"computer", computer},
                    {"date", date},
                    {"world", world},
                    {"mapping_p95_mm", mapping_p95_mm}}
               .dump() +
           '\n';
  }
  [[nodiscard]] bool is_measured_alike(const StudyHead& other) const {
    return of == other.of && program_version == other.program_version &&
           computer == other.computer && world == other.world;
  }
};

struct StudyFileContent {
  StudyHead head;
  std::vector<StudyRow> rows;
};

Error no_study(const std::filesystem::path& file) {
  return {en::say("is not a study file of this program"), file.string(),
          en::say("remove it, and the study begins anew")};
}

Result<std::optional<StudyFileContent>> read_study(const std::filesystem::path& file) {
  std::error_code absent;
  if (!std::filesystem::exists(file, absent)) return std::optional<StudyFileContent>();
  const auto text = read_file(file);
  if (!text) return text.error();
  const std::size_t end = text->find('\n');
  if (end == std::string::npos) return no_study(file);
  const FileJson json = FileJson::parse(text->substr(0, end), nullptr, false);
  const auto text_at = [&](const char* key) {
    return json.is_object() && json.contains(key) && json.at(key).is_string()
               ? json.at(key).get<std::string>()
               : std::string();
  };
  if (text_at("format") != kStudyFormat) return no_study(file);
  const bool has_mapping = json.contains("mapping_p95_mm") && json.at("mapping_p95_mm").is_number();
  StudyFileContent content{
      {text_at("of"), text_at("program_version"), text_at("computer"), text_at("date"),
       text_at("world"), has_mapping ? json.at("mapping_p95_mm").get<double>() : 0.0},
      {}};
  auto rows = rows_of_lines(std::string_view(*text).substr(end + 1), file.string());
  if (!rows) return rows.error();
  content.rows = std::move(rows).value();
  return std::optional(std::move(content));
}

/// Checksum of everything besides the settings that a frame's depth depends on.
Result<std::string> checksum_of_finger(const FingerSnapshot& finger) {
  const auto reference = reference_checksum(finger.folder, finger.finger);
  if (!reference) return reference.error();
  Finger only;  // without the fields that depth does not depend on
  only.name = "finger";
  only.camera = finger.finger.camera;
  only.face = finger.finger.face;
  only.markers = finger.finger.markers;
  only.mapping = finger.finger.mapping;
  const auto yaml = only.to_yaml();
  if (!yaml) return yaml.error();
  return fmt::format("{} {} {:08x}", finger_checksum(finger.finger), *reference, fnv1a(*yaml));
}

StudyHead head_here_and_now(const std::string& of, std::uint64_t world, double mapping_p95_mm,
                            const std::string& program_version) {
  return {of,
          program_version,
          this_machine().processor,
          utc_now(),
          fmt::format("{:016x}", world),
          mapping_p95_mm};
}

Status write_study(const std::filesystem::path& file, const StudyFileContent& content) {
  std::string text = content.head.line();
  for (const StudyRow& row : content.rows) text += line_of(row);
  return write_file_atomically(file, text);
}

bool has_all(const std::vector<StudyRow>& rows, StudyExtent extent, const Finger& finger) {
  std::set<std::string> known;
  for (const StudyRow& row : rows) known.insert(key_of(row.settings));
  const auto choices = study_choices(rows.front().settings, extent, finger);
  return std::all_of(choices.begin(), choices.end(), [&](const PipelineSettings& choice) {
    return known.count(key_of(choice)) == 1;
  });
}

FingerStudy finger_study(const FingerSnapshot& finger, const StudyFileContent& content,
                         const std::string& of_now) {
  FingerStudy stored;
  stored.study = {en::say("balls painted into untouched images of {}", finger.finger.name), false,
                  0, content.rows, content.head.mapping_p95_mm};
  stored.date = content.head.date;
  stored.computer = content.head.computer;
  stored.is_of_finger_now = content.head.of == of_now;
  stored.is_of_this_computer = content.head.computer == this_machine().processor;
  stored.has_all_single = has_all(content.rows, StudyExtent::kQuick, finger.finger);
  stored.has_all_pairs = has_all(content.rows, StudyExtent::kPairs, finger.finger);
  return stored;
}

}  // namespace

Result<std::optional<FingerStudy>> stored_study(const FingerPtr& finger) {
  const auto content = read_study(finger->folder / kFingerStudy);
  if (!content) return content.error();
  if (!*content || (*content)->rows.empty()) return std::optional<FingerStudy>();
  const auto now = checksum_of_finger(*finger);
  return std::optional(finger_study(*finger, **content, now ? *now : std::string()));
}

Result<FingerStudy> study_finger(const FingerPtr& finger, StudyExtent extent,
                                 const std::string& program_version, const Job& job) {
  const auto of = checksum_of_finger(*finger);
  if (!of) return of.error();
  StudyWorldOptions world_options;
  world_options.frames = kFingerStudyFrames;
  const auto world = painted_world(finger, world_options, Job(job, 0.0, kPaintingPart));
  if (!world) return world.error();
  StudyOptions how;
  how.extent = extent;
  how.base = calibrated_settings(finger->folder);
  how.repeats = kFingerStudyRepeats;
  const auto file = finger->folder / kFingerStudy;
  StudyFileContent content{
      head_here_and_now(*of, world->checksum, world->mapping_p95_mm, program_version), {}};
  // A file that cannot be read is measured again.
  const auto before = read_study(file);
  if (before && *before && (*before)->head.is_measured_alike(content.head) &&
      !(*before)->rows.empty() && key_of((*before)->rows.front().settings) == key_of(how.base))
    content = **before;
  const auto save = [&](const std::vector<StudyRow>& more) {
    content.rows.insert(content.rows.end(), more.begin(), more.end());
    return write_study(file, content);
  };
  const auto done = study_accuracy(*world, how, content.rows, save, Job(job, kPaintingPart, 1.0));
  if (!done) return done.error();
  return finger_study(*finger, content, *of);
}

Status store_study(const FingerPtr& finger, const AccuracyStudy& study,
                   const std::string& program_version) {
  const auto of = checksum_of_finger(*finger);
  if (!of) return of.error();
  return write_study(
      finger->folder / kFingerStudy,
      {head_here_and_now(*of, study.world_checksum, study.mapping_p95_mm, program_version),
       study.rows});
}

}  // namespace alltact
