#include "calibration/study/study_file.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"
#include "calibration/study/study_machine.h"
#include "core/base/atomic_file.h"
#include "core/base/json_fields.h"
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

void describe_zones(JsonFields& fields,
                    std::array<std::optional<ErrorSpread>, kFaceZones>& depth_by_zone) {
  for (std::size_t zone = 0; zone < kFaceZones; ++zone)
    fields.field(std::string("depth_") + kZoneKeys[zone], depth_by_zone[zone]);
}

void describe_errors(JsonFields& errors, StudyRow& row) {
  errors.field("frames", row.frames);
  errors.field("frames_missing", row.frames_missing);
  errors.field("depth", row.depth);
  describe_zones(errors, row.depth_by_zone);
  errors.field("coverage", row.coverage);
  errors.field("false_depth_mm", row.false_depth_mm);
  errors.field("place_mm", row.position_mm);
  errors.field("place_p95_mm", row.position_p95_mm);
  errors.field("angle_deg", row.angle_deg);
  errors.field("angle_p95_deg", row.angle_p95_deg);
  errors.field("bars", row.bars);
  errors.field("bars_missing", row.bars_missing);
}

/// Refuses an unknown setting, or a value outside its range.
void describe_settings(JsonFields& fields, PipelineSettings& settings) {
  for (const auto& setting : pipeline_settings()) {
    std::string value = setting.get(settings);
    fields.field(setting.name, value);
    if (fields.is_reading() && !setting.set(settings, value)) throw std::out_of_range(setting.name);
  }
}

}  // namespace

static void describe(JsonFields& fields, ErrorSpread& spread) {
  fields.field("median_mm", spread.median_mm);
  fields.field("p95_mm", spread.p95_mm);
}

static void describe(JsonFields& fields, RealErrors& real) {
  fields.field("presses", real.presses);
  fields.field("presses_missing", real.presses_missing);
  std::optional<ErrorSpread> depth = real.depth;
  fields.field("depth", depth);
  real.depth = *depth;  // the file may lack it
  describe_zones(fields, real.depth_by_zone);
}

static void describe(JsonFields& fields, StudyRow& row) {
  fields.section("settings", [&](JsonFields& inner) { describe_settings(inner, row.settings); });
  fields.section("errors", [&](JsonFields& inner) { describe_errors(inner, row); });
  fields.section("times", [&](JsonFields& times) {
    times.field("median_ms", row.time_ms);
    times.field("p95_ms", row.time_p95_ms);
    times.field("ratio", row.time_ratio);
    times.field("memory_bytes", row.memory_bytes);
  });
  fields.field("real", row.real);
}

namespace {

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

std::string line_of(const StudyRow& row) { return Json(written_json(row)).dump() + "\n"; }

Result<std::vector<StudyRow>> rows_of_lines(std::string_view lines, const std::string& where) {
  std::vector<StudyRow> rows;
  while (!lines.empty()) {
    const std::size_t end = lines.find('\n');
    if (end == std::string_view::npos) break;  // truncated while it was written
    try {
      const auto json = JsonFields::Json::parse(lines.substr(0, end));
      JsonFields fields(json, {});
      describe(fields, rows.emplace_back());
    } catch (const std::exception&) {
      return Error{en::say("is not a study file of this program"), where,
                   en::say("remove it, and the study begins anew")};
    }
    lines.remove_prefix(end + 1);
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
    Json entry = written_json(row);
    entry["words"] = words_of(row.settings, study.rows.front().settings).english();
    entry["on_front"] = std::find(front.begin(), front.end(), i) != front.end();
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
