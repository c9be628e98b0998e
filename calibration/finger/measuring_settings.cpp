#include "calibration/finger/measuring_settings.h"

#include "calibration/finger/calibration_inputs.h"
#include "calibration/finger/measuring_presets.h"

namespace alltact {

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
