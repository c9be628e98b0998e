#include "app/commands/stored_settings.h"

#include "calibration/finger/measuring_presets.h"

#include <algorithm>

#include <fmt/format.h>

namespace alltact {
namespace {

bool is_of_mapping(const std::string& setting) {
  const auto& beyond = mapping_independent_settings();
  return std::find(beyond.begin(), beyond.end(), setting) == beyond.end();
}

}  // namespace

Result<PipelineSettings> stored_settings(const std::filesystem::path& finger,
                                         const std::string& preset) {
  if (!preset.empty()) return preset_settings(finger, preset);
  const auto presets = presets_of_finger(finger);
  if (!presets) return presets.error();
  return presets->now;
}

void warn_of_other_settings(const PipelineSettings& stored,
                            const PipelineSettings& requested,
                            Console& console) {
  for (const auto& setting : pipeline_settings())
    if (is_of_mapping(setting.name) && setting.get(stored) != setting.get(requested))
      console.warn(fmt::format("Warning: --{} is {}, and the finger was calibrated with {}.",
                               setting.name,
                               setting.get(requested),
                               setting.get(stored)));
}

}  // namespace alltact
