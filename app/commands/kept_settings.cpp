#include "app/commands/kept_settings.h"

#include "calibration/finger/measuring_presets.h"

#include <algorithm>

#include <fmt/format.h>

namespace alltact {
namespace {

bool is_of_mapping(const std::string& setting) {
  const auto& beyond = settings_beyond_mapping();
  return std::find(beyond.begin(), beyond.end(), setting) == beyond.end();
}

}  // namespace

Result<PipelineSettings> kept_settings(const std::filesystem::path& finger,
                                       const std::string& preset) {
  if (!preset.empty()) return preset_settings(finger, preset);
  const auto presets = presets_of_finger(finger);
  if (!presets) return presets.error();
  return presets->now;
}

void warn_of_other_settings(const PipelineSettings& kept,
                            const PipelineSettings& asked,
                            Console& console) {
  for (const auto& setting : pipeline_settings())
    if (is_of_mapping(setting.name) && setting.get(kept) != setting.get(asked))
      console.warn(fmt::format("Warning: --{} is {}, and the finger was calibrated with {}.",
                               setting.name,
                               setting.get(asked),
                               setting.get(kept)));
}

}  // namespace alltact
