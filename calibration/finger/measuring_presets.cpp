#include "calibration/finger/measuring_presets.h"

#include "calibration/finger/calibration_inputs.h"
#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/yaml.h"

#include <algorithm>
#include <cassert>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr Limits kFigure{0.0, 1e6};

/// Content of measuring.yaml, with settings as differences.
struct MeasuringFile {
  struct Preset {
    std::string name;
    double frame_ms = 0, median_mm = 0, p95_mm = 0;
    std::map<std::string, std::string> changes;
  };
  std::string used;
  std::map<std::string, std::string> used_changes;
  std::string date, program_version, machine, about;
  std::map<std::string, std::string> base;
  std::vector<Preset> presets;
};

const Setting<PipelineSettings>* setting_named(const std::string& name) {
  for (const auto& setting : pipeline_settings())
    if (setting.name == name) return &setting;
  return nullptr;
}

/// Rejects values that this version cannot set. Requested settings of another version are
/// preserved, but not used.
std::map<std::string, std::string> read_changes(YamlSection section) {
  std::map<std::string, std::string> changes;
  for (const auto& [name, value] : section.all_texts()) {
    const auto* setting = setting_named(name);
    if (setting == nullptr)
      section.refuse(name, en::say("is not a setting of this version"), en::say("a new study"));
    PipelineSettings scratch;
    if (const Status status = setting->set(scratch, value); !status)
      section.refuse(name, status.error().what, Message::typed(setting->range.text()));
    changes[name] = value;
  }
  return changes;
}

MeasuringFile::Preset read_preset(const std::string& name, YamlSection section) {
  MeasuringFile::Preset preset;
  preset.name = name;
  preset.frame_ms = section.number("frame_ms", kFigure);
  preset.median_mm = section.number("median_mm", kFigure);
  preset.p95_mm = section.number("p95_mm", kFigure);
  if (section.has_section("settings")) preset.changes = read_changes(section.section("settings"));
  return preset;
}

MeasuringFile read_measuring(YamlSection& top) {
  MeasuringFile file;
  if (const std::string format = top.text("format"); format != MeasuringPresets::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)),
               en::say("studying the finger again"));
  if (top.has("used")) file.used = top.text("used");
  if (top.has_section("used_settings"))
    file.used_changes = read_changes(top.section("used_settings"));
  if (!top.has_section("study")) return file;
  YamlSection study = top.section("study");
  file.date = study.text("date");
  file.program_version = study.text("program_version");
  file.machine = study.text("machine");
  file.about = study.text("about");
  file.base = read_changes(top.section("base"));
  if (!top.has_section("presets")) return file;
  YamlSection presets = top.section("presets");
  for (const std::string& name : presets.keys())
    file.presets.push_back(read_preset(name, presets.section(name)));
  return file;
}

fs::path file_in(const fs::path& folder) { return folder / kMeasuringFile; }

/// Empty where there is no such file.
Result<MeasuringFile> load_measuring(const fs::path& folder) {
  std::error_code failed;
  if (folder.empty() || !fs::exists(file_in(folder), failed)) return MeasuringFile{};
  const auto content = read_file(file_in(folder), YamlFile::kMaxBytes);
  if (!content) return content.error();
  YamlFile yaml(file_in(folder));
  MeasuringFile file;
  const Status read = yaml.read(*content, [&](YamlSection& top) { file = read_measuring(top); });
  if (!read) return read.error();
  return file;
}

std::string in_braces(const std::map<std::string, std::string>& values) {
  YamlBlock block("");
  for (const auto& setting : pipeline_settings())
    if (const auto found = values.find(setting.name); found != values.end())
      block.add(setting.name, yaml_text_or_number(found->second));
  return block.in_braces();
}

std::string yaml_of(const MeasuringFile& file) {
  YamlBlock head("");
  head.add("format", MeasuringPresets::kFormat);
  if (!file.used.empty()) {
    head.add("used", yaml_text(file.used));
    if (!file.used_changes.empty()) head.add("used_settings", in_braces(file.used_changes));
  }
  std::string text = head.on_many_lines();
  if (file.date.empty()) return text;
  YamlBlock study("study");
  study.add("date", yaml_text(file.date));
  study.add("program_version", yaml_text(file.program_version));
  study.add("machine", yaml_text(file.machine));
  study.add("about", yaml_text(file.about));
  text += study.on_many_lines();
  YamlBlock rest("");
  rest.add("base", in_braces(file.base));
  text += rest.on_many_lines();
  YamlBlock presets("presets");
  for (const auto& preset : file.presets) {
    YamlBlock one("");
    one.add("frame_ms", yaml_number(preset.frame_ms));
    one.add("median_mm", yaml_number(preset.median_mm));
    one.add("p95_mm", yaml_number(preset.p95_mm));
    if (!preset.changes.empty()) one.add("settings", in_braces(preset.changes));
    presets.add(preset.name, one.in_braces());
  }
  return presets.is_empty() ? text : text + presets.on_many_lines();
}

PipelineSettings with_changes(PipelineSettings settings,
                              const std::map<std::string, std::string>& changes) {
  for (const auto& [name, value] : changes) {
    [[maybe_unused]] const Status status = setting_named(name)->set(settings, value);
    assert(status.ok());  // was checked when it was read
  }
  return settings;
}

std::map<std::string, std::string> changes_between(const PipelineSettings& base,
                                                   const PipelineSettings& settings) {
  std::map<std::string, std::string> changes;
  for (const auto& setting : pipeline_settings())
    if (setting.get(settings) != setting.get(base)) changes[setting.name] = setting.get(settings);
  return changes;
}

/// Rewrites the file, including concurrent changes of other programs.
Status change_file(FingerStore& store, const std::function<void(MeasuringFile&)>& change) {
  return store.save_measuring([&](const fs::path& folder) -> Result<std::string> {
    auto file = load_measuring(folder);
    if (!file) return file.error();
    change(*file);
    return yaml_of(*file);
  });
}

}  // namespace

const MeasuringPreset* MeasuringPresets::find(const std::string& name) const {
  for (const MeasuringPreset& preset : presets)
    if (preset.name == name) return &preset;
  return nullptr;
}

Result<MeasuringPresets> presets_of_finger(const fs::path& folder) {
  const auto file = load_measuring(folder);
  if (!file) return file.error();
  MeasuringPresets stored;
  stored.calibrated = calibrated_settings(folder);
  stored.now = with_changes(stored.calibrated, file->used_changes);
  stored.used = file->used;
  stored.date = file->date;
  stored.program_version = file->program_version;
  stored.machine = file->machine;
  stored.about = file->about;
  // A setting that the file does not name did not exist at that time: it had its default value.
  stored.is_stale = !file->date.empty() &&
                    !changes_between(stored.calibrated, with_changes({}, file->base)).empty();
  for (const auto& preset : file->presets)
    stored.presets.push_back({preset.name, with_changes(stored.calibrated, preset.changes),
                              preset.frame_ms, preset.median_mm, preset.p95_mm});
  return stored;
}

Status save_presets(FingerStore& store, const MeasuringPresets& presets) {
  return change_file(store, [&](MeasuringFile& file) {
    file.date = presets.date;
    file.program_version = presets.program_version;
    file.machine = presets.machine;
    file.about = presets.about;
    file.base.clear();
    for (const auto& setting : pipeline_settings())
      file.base[setting.name] = setting.get(presets.calibrated);
    file.presets.clear();
    for (const MeasuringPreset& preset : presets.presets)
      file.presets.push_back({preset.name, preset.frame_ms, preset.median_mm, preset.p95_mm,
                              changes_between(presets.calibrated, preset.settings)});
  });
}

Status use_settings(FingerStore& store, const PipelineSettings& settings, const std::string& name) {
  assert(!name.empty());
  const PipelineSettings base = calibrated_settings(store.folder());
  return change_file(store, [&](MeasuringFile& file) {
    file.used = name;
    file.used_changes = changes_between(base, settings);
  });
}

Status use_calibrated_settings(FingerStore& store) {
  std::error_code failed;
  if (!fs::exists(file_in(store.folder()), failed)) return {};
  return change_file(store, [](MeasuringFile& file) {
    file.used.clear();
    file.used_changes.clear();
  });
}

Result<PipelineSettings> preset_settings(const fs::path& folder, const std::string& name) {
  const auto stored = presets_of_finger(folder);
  if (!stored) return stored.error();
  if (const MeasuringPreset* preset = stored->find(name)) return preset->settings;
  if (name == "balanced" || name == "calibrated") return stored->calibrated;
  if (stored->date.empty())
    return Error{en::say("this finger has no presets: it was not studied yet"), folder.string(),
                 en::say("alltact study {} --save", folder.string())};
  std::vector<std::string> names{"calibrated"};
  for (const MeasuringPreset& preset : stored->presets) names.push_back(preset.name);
  if (name == "fast" || name == "finest")
    return Error{
        name == "fast"
            ? en::say("no setting is faster on this finger without an error half as large again")
            : en::say("no setting is more accurate on this finger than those of its calibration"),
        folder.string(), en::say("measuring with {}", either(names))};
  return Error{en::say("'{}' is not a preset of this finger", printable(name)), folder.string(),
               en::say("{}", either(names))};
}

PipelineSettings calibrated_settings(const std::filesystem::path& finger_folder) {
  const PipelineSettings defaults;
  const auto inputs = CalibrationInputs::load(finger_folder);
  if (!inputs) return defaults;
  PipelineSettings settings = inputs->pipeline;
  settings.contact_threshold_mm = defaults.contact_threshold_mm;
  return settings;
}

PipelineSettings measuring_settings(const std::filesystem::path& finger_folder) {
  const auto presets = presets_of_finger(finger_folder);
  return presets ? presets->now : calibrated_settings(finger_folder);
}

}  // namespace alltact
