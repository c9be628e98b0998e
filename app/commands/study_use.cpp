#include "app/commands/study_use.h"

#include "calibration/finger/measuring_presets.h"
#include "calibration/study/study_choice.h"
#include "calibration/study/study_presets.h"

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr const char* kWithin = "within-ms";
constexpr const char* kKeep = "keep-mm";
constexpr const char* kCalibrated = "calibrated";

Status use(const Path& finger,
           const PipelineSettings& settings,
           const std::string& name,
           Console& console) {
  const auto store = FingerStore::of(finger);
  if (const Status used = use_settings(*store, settings, name); !used) return used;
  const auto presets = presets_of_finger(finger);
  if (!presets) return presets.error();
  const std::string flags = flags_of(settings, presets->calibrated);
  console.say(
      fmt::format("{} measures as '{}' from now on: {}. The way back: alltact study {} "
                  "--use {}",
                  finger.string(),
                  name,
                  flags.empty() ? "as it was calibrated" : flags,
                  finger.string(),
                  kCalibrated));
  console.answer()["used"] = {{"name", name}, {"flags", flags}};
  return {};
}

/// The row within a limit, with the request as text.
Result<std::pair<std::size_t, std::string>> row_within(const StudyCommandOptions& options,
                                                       const AccuracyStudy& study) {
  const bool is_time = options.use == kWithin;
  const auto row = is_time ? most_accurate_within(study, *options.max_time_ms, options.position_mm)
                           : fastest_within(study, *options.max_error_mm, options.position_mm);
  const std::string name = is_time ? fmt::format("within {} ms", *options.max_time_ms)
                                   : fmt::format("95 % within {} mm", *options.max_error_mm);
  if (!row)
    return Error{en::say("no setting is {}", name),
                 "",
                 en::say("a wider limit; the table above tells what there is")};
  return std::pair{*row, name};
}

}  // namespace

void add_use_flags(CLI::App& command, StudyCommandOptions& options) {
  command.add_flag("--save",
                   options.save,
                   "Keep the presets fast, balanced and finest with the finger, for --preset");
  command
      .add_option("--use",
                  options.use,
                  "Let the finger measure with it from now on, everywhere: a preset that it keeps "
                  "or, with --save, that this study finds; within-ms or keep-mm, what those "
                  "options find; calibrated, the way back")
      ->type_name("NAME")
      ->check(CLI::IsMember({"fast", "balanced", "finest", kCalibrated, kWithin, kKeep}));
}

void check_use_flags(const StudyCommandOptions& options) {
  if ((options.save || !options.use.empty()) && options.fingers.empty())
    throw CLI::ValidationError(options.save ? "--save" : "--use", "there is no finger to keep it");
  if ((options.save || !options.use.empty()) &&
      (options.calibrating || options.simulating || options.scaling))
    throw CLI::ValidationError(options.save ? "--save" : "--use",
                               "that study tells nothing of what frames are measured with");
  if (options.use == kWithin && !options.max_time_ms) throw CLI::RequiredError("--within-ms");
  if (options.use == kKeep && !options.max_error_mm) throw CLI::RequiredError("--keep-mm");
}

bool uses_stored_preset(const StudyCommandOptions& options) {
  return !options.save && !options.use.empty() && options.use != kWithin && options.use != kKeep;
}

Status use_stored_preset(const Path& finger, const std::string& name, Console& console) {
  if (name == kCalibrated) {
    const auto store = FingerStore::of(finger);
    if (const auto there = store->snapshot(); !there) return there.error();
    if (const Status back = use_calibrated_settings(*store); !back) return back;
    console.say(fmt::format("{} measures as it was calibrated from now on.", finger.string()));
    console.answer()["used"] = {{"name", name}, {"flags", ""}};
    return {};
  }
  const auto settings = preset_settings(finger, name);
  if (!settings) return settings.error();
  return use(finger, *settings, name, console);
}

Status save_and_use(const StudyCommandOptions& options,
                    const AccuracyStudy& study,
                    const Path& finger,
                    const std::string& machine,
                    Console& console) {
  if (options.save) {
    const auto store = FingerStore::of(finger);
    const MeasuringPresets presets = presets_to_save(study, machine);
    if (const Status saved = save_presets(*store, presets); !saved) return saved;
    std::vector<std::string> names;
    for (const MeasuringPreset& preset : presets.presets) names.push_back(preset.name);
    console.say(fmt::format(
        "Kept with {}: {}.", finger.string(), fmt::format("{}", fmt::join(names, ", "))));
    console.answer()["kept"] = names;
  }
  if (options.use == kWithin || options.use == kKeep) {
    const auto row = row_within(options, study);
    if (!row) return row.error();
    return use(finger, study.rows[row->first].settings, row->second, console);
  }
  if (options.save && !options.use.empty()) return use_stored_preset(finger, options.use, console);
  return {};
}

}  // namespace alltact
