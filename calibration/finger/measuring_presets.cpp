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

/// Settings by their names.
using Changes = std::map<std::string, std::string>;

/// Content of measuring.yaml: settings are differences, those in `stored` are not set.
struct MeasuringFile {
  MeasuringPresets stored;
  Changes used_changes, base;
  std::map<std::string, Changes> preset_changes;  ///< by the presets' names
};

const Setting<PipelineSettings>* setting_named(const std::string& name) {
  for (const auto& setting : pipeline_settings())
    if (setting.name == name) return &setting;
  return nullptr;
}

/// Rejects values that this version cannot set. Requested settings of another version are
/// preserved, but not used.
Changes read_changes(YamlSection section) {
  Changes changes;
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

void read_preset(const std::string& name, YamlSection section, MeasuringFile& file) {
  MeasuringPreset preset;
  preset.name = name;
  preset.frame_ms = section.number("frame_ms", kFigure);
  preset.median_mm = section.number("median_mm", kFigure);
  preset.p95_mm = section.number("p95_mm", kFigure);
  file.stored.presets.push_back(std::move(preset));
  if (section.has_section("settings"))
    file.preset_changes[name] = read_changes(section.section("settings"));
}

MeasuringFile read_measuring(YamlSection& top) {
  MeasuringFile file;
  if (const std::string format = top.text("format"); format != MeasuringPresets::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)),
               en::say("studying the finger again"));
  if (top.has("used")) file.stored.used = top.text("used");
  if (top.has_section("used_settings"))
    file.used_changes = read_changes(top.section("used_settings"));
  if (!top.has_section("study")) return file;
  YamlSection study = top.section("study");
  file.stored.date = study.text("date");
  file.stored.program_version = study.text("program_version");
  file.stored.machine = study.text("machine");
  file.stored.about = study.text("about");
  file.base = read_changes(top.section("base"));
  if (!top.has_section("presets")) return file;
  YamlSection presets = top.section("presets");
  for (const std::string& name : presets.keys()) read_preset(name, presets.section(name), file);
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

std::string in_braces(const Changes& values) {
  YamlBlock block("");
  for (const auto& setting : pipeline_settings())
    if (const auto found = values.find(setting.name); found != values.end())
      block.add(setting.name, yaml_text_or_number(found->second));
  return block.in_braces();
}

std::string yaml_of(const MeasuringFile& file) {
  const MeasuringPresets& stored = file.stored;
  YamlBlock head("");
  head.add("format", MeasuringPresets::kFormat);
  if (!stored.used.empty()) {
    head.add("used", yaml_text(stored.used));
    if (!file.used_changes.empty()) head.add("used_settings", in_braces(file.used_changes));
  }
  std::string text = head.on_many_lines();
  if (stored.date.empty()) return text;
  YamlBlock study("study");
  study.add("date", yaml_text(stored.date));
  study.add("program_version", yaml_text(stored.program_version));
  study.add("machine", yaml_text(stored.machine));
  study.add("about", yaml_text(stored.about));
  text += study.on_many_lines();
  YamlBlock rest("");
  rest.add("base", in_braces(file.base));
  text += rest.on_many_lines();
  YamlBlock presets("presets");
  for (const auto& preset : stored.presets) {
    YamlBlock one("");
    one.add("frame_ms", yaml_number(preset.frame_ms));
    one.add("median_mm", yaml_number(preset.median_mm));
    one.add("p95_mm", yaml_number(preset.p95_mm));
    if (const auto changes = file.preset_changes.find(preset.name);
        changes != file.preset_changes.end() && !changes->second.empty())
      one.add("settings", in_braces(changes->second));
    presets.add(preset.name, one.in_braces());
  }
  return presets.is_empty() ? text : text + presets.on_many_lines();
}

PipelineSettings with_changes(PipelineSettings settings, const Changes& changes) {
  for (const auto& [name, value] : changes) {
    [[maybe_unused]] const Status status = setting_named(name)->set(settings, value);
    assert(status.ok());  // was checked when it was read
  }
  return settings;
}

Changes changes_between(const PipelineSettings& base, const PipelineSettings& settings) {
  Changes changes;
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
  auto file = load_measuring(folder);
  if (!file) return file.error();
  MeasuringPresets stored = std::move(file->stored);
  stored.calibrated = calibrated_settings(folder);
  stored.now = with_changes(stored.calibrated, file->used_changes);
  // A setting that the file does not name did not exist at that time: it had its default value.
  stored.is_stale = !stored.date.empty() &&
                    !changes_between(stored.calibrated, with_changes({}, file->base)).empty();
  for (MeasuringPreset& preset : stored.presets)
    preset.settings = with_changes(stored.calibrated, file->preset_changes[preset.name]);
  return stored;
}

Status save_presets(FingerStore& store, const MeasuringPresets& presets) {
  return change_file(store, [&](MeasuringFile& file) {
    const std::string used = file.stored.used;
    file.stored = presets;
    file.stored.used = used;
    file.base.clear();
    for (const auto& setting : pipeline_settings())
      file.base[setting.name] = setting.get(presets.calibrated);
    file.preset_changes.clear();
    for (const MeasuringPreset& preset : presets.presets)
      file.preset_changes[preset.name] = changes_between(presets.calibrated, preset.settings);
  });
}

Status use_settings(FingerStore& store, const PipelineSettings& settings, const std::string& name) {
  assert(!name.empty());
  const PipelineSettings base = calibrated_settings(store.folder());
  return change_file(store, [&](MeasuringFile& file) {
    file.stored.used = name;
    file.used_changes = changes_between(base, settings);
  });
}

Status use_calibrated_settings(FingerStore& store) {
  std::error_code failed;
  if (!fs::exists(file_in(store.folder()), failed)) return {};
  return change_file(store, [](MeasuringFile& file) {
    file.stored.used.clear();
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
