#include "calibration/study/finger_study.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_settings.h"
#include "calibration/study/study_file.h"
#include "calibration/study/study_machine.h"
#include "core/io/atomic_file.h"
#include "core/numerics/philox.h"
#include "core/utc_time.h"

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace alltact {
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
  return {en::say("is not what a study of this program keeps"),
          file.string(),
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
  StudyFileContent content{{text_at("of"),
                            text_at("program_version"),
                            text_at("computer"),
                            text_at("date"),
                            text_at("world"),
                            has_mapping ? json.at("mapping_p95_mm").get<double>() : 0.0},
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

StudyHead head_here_and_now(const std::string& of,
                            std::uint64_t world,
                            double mapping_p95_mm,
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

FingerStudy finger_study(const FingerSnapshot& finger,
                         const StudyFileContent& content,
                         const std::string& of_now) {
  FingerStudy stored;
  stored.study = {en::say("balls painted into untouched pictures of {}", finger.finger.name),
                  false,
                  0,
                  content.rows,
                  content.head.mapping_p95_mm};
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

Result<FingerStudy> study_finger(const FingerPtr& finger,
                                 StudyExtent extent,
                                 const std::string& program_version,
                                 const Job& job) {
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

Status store_study(const FingerPtr& finger,
                   const AccuracyStudy& study,
                   const std::string& program_version) {
  const auto of = checksum_of_finger(*finger);
  if (!of) return of.error();
  return write_study(
      finger->folder / kFingerStudy,
      {head_here_and_now(*of, study.world_checksum, study.mapping_p95_mm, program_version),
       study.rows});
}

}  // namespace alltact
