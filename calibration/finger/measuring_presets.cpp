#include "calibration/finger/measuring_presets.h"

#include "calibration/finger/calibration_inputs.h"
#include "core/base/atomic_file.h"
#include "core/base/fields.h"
#include "core/base/message.h"

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

/// True where the file has a block of this key; another value counts as unknown.
bool has_block(Fields& fields, const char* key, bool is_written) {
  return fields.is_reading() ? fields.section().has_section(key) : is_written;
}

/// Rejects values that this version cannot set. Requested settings of another version are
/// preserved, but not used.
void describe_changes(Fields& fields, const char* key, Changes& changes) {
  fields.section(key, Fields::Layout::kBraces, [&](Fields& inner) {
    if (!inner.is_reading()) {
      for (const auto& setting : pipeline_settings())
        if (const auto found = changes.find(setting.name); found != changes.end())
          inner.text_or_number(setting.name, found->second);
      return;
    }
    changes = inner.section().all_texts();
    for (const auto& [name, value] : changes) {
      const auto* setting = setting_named(name);
      if (setting == nullptr)
        inner.section().refuse(name, en::say("is not a setting of this version"),
                               en::say("a new study"));
      PipelineSettings scratch;
      if (const Status status = setting->set(scratch, value); !status)
        inner.section().refuse(name, status.error().what, Message::typed(setting->range.text()));
    }
  });
}

void describe_preset(Fields& fields, MeasuringPreset& preset, Changes& changes) {
  fields.number("frame_ms", preset.frame_ms, kFigure);
  fields.number("median_mm", preset.median_mm, kFigure);
  fields.number("p95_mm", preset.p95_mm, kFigure);
  if (has_block(fields, "settings", !changes.empty()))
    describe_changes(fields, "settings", changes);
}

void describe(Fields& fields, MeasuringFile& file) {
  using Layout = Fields::Layout;
  MeasuringPresets& stored = file.stored;
  fields.format(MeasuringPresets::kFormat, en::say("studying the finger again"));
  fields.text(may("used", !stored.used.empty()), stored.used);
  if (has_block(fields, "used_settings", !stored.used.empty() && !file.used_changes.empty()))
    describe_changes(fields, "used_settings", file.used_changes);
  if (!has_block(fields, "study", !stored.date.empty())) return;
  fields.section("study", Layout::kLines, [&](Fields& study) {
    study.text("date", stored.date);
    study.text("program_version", stored.program_version);
    study.text("machine", stored.machine);
    study.text("about", stored.about);
  });
  describe_changes(fields, "base", file.base);
  if (!has_block(fields, "presets", !stored.presets.empty())) return;
  fields.section("presets", Layout::kLines, [&](Fields& presets) {
    if (presets.is_reading())
      for (const std::string& name : presets.section().keys())
        stored.presets.emplace_back().name = name;
    for (MeasuringPreset& preset : stored.presets)
      presets.section(preset.name, Layout::kBraces, [&](Fields& one) {
        describe_preset(one, preset, file.preset_changes[preset.name]);
      });
  });
}

fs::path file_in(const fs::path& folder) { return folder / kMeasuringFile; }

/// Empty where there is no such file.
Result<MeasuringFile> load_measuring(const fs::path& folder) {
  std::error_code failed;
  if (folder.empty() || !fs::exists(file_in(folder), failed)) return MeasuringFile{};
  const auto content = read_file(file_in(folder), YamlFile::kMaxBytes);
  if (!content) return content.error();
  YamlFile yaml(file_in(folder));
  return read_fields<MeasuringFile>(yaml, *content);
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
    return fields_text(*file);
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
