// Measuring settings of a finger: named presets from a study of this finger, stored with it, and
// the settings in use. measuring.yaml next to finger.yaml:
//   format: alltact-measuring/1
//   used: fast                        # name, or the request in words; absent: as it was calibrated
//   used_settings: {reference-neighbours: 4}   # what differs from the calibration's
//   study: {date: "2026-01-31T12:00:00Z", program_version: 0.1.0, machine: ..., about: ...}
//   base: {edge-method: crossing, ...}  # the calibration's settings at that time
//   presets:
//     fast: {frame_ms: 1.1, median_mm: 0.012, p95_mm: 0.05, settings: {reference-neighbours: 4}}
// Settings are stored as differences. After a new calibration with other settings they still hold
// those that the mapping requires.
#pragma once

#include "core/base/result.h"
#include "core/finger/finger_store.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

/// Named settings, and the results of a study with them.
struct MeasuringPreset {
  std::string name;           ///< "fast", "balanced", "finest"
  PipelineSettings settings;  ///< complete: the calibration's with the differences
  double frame_ms = 0;        ///< median of a frame on that computer
  double median_mm = 0;       ///< of the error of depth
  double p95_mm = 0;
};

struct MeasuringPresets {
  static constexpr const char* kFormat = "alltact-measuring/1";

  // Of the study; empty: none is stored.
  std::string date;             ///< UTC, as utc_now() writes it
  std::string program_version;  ///< that measured
  std::string machine;          ///< processor and number of threads
  std::string about;            ///< subject of the study
  /// Only those that improve something on this finger.
  std::vector<MeasuringPreset> presets;
  /// The finger was calibrated with other settings than when it was studied: the presets can be
  /// used, their figures are outdated.
  bool is_stale = false;

  /// The settings in use: a preset's name, or the request ("within 5 ms"); empty: as it was
  /// calibrated.
  std::string used;
  PipelineSettings now;         ///< those settings, complete
  PipelineSettings calibrated;  ///< those of the calibration

  /// nullptr: there is none of this name.
  [[nodiscard]] const MeasuringPreset* find(const std::string& name) const;
};

/// The stored presets; only `now` and `calibrated` where none are stored. Errors: a file that
/// cannot be read or holds something impossible.
[[nodiscard]] Result<MeasuringPresets> presets_of_finger(const std::filesystem::path& folder);

/// Replaces the study's part (date to presets); the settings in use stay. `presets.calibrated`
/// counts as the base settings of the study.
[[nodiscard]] Status save_presets(FingerStore& store, const MeasuringPresets& presets);

/// The finger uses these settings from now on, everywhere: live,
/// reconstruct, check, in every window.
///   name: of the preset, or the request in words; not empty
[[nodiscard]] Status use_settings(FingerStore& store, const PipelineSettings& settings,
                                  const std::string& name);
/// Restores the calibration's settings.
[[nodiscard]] Status use_calibrated_settings(FingerStore& store);

/// Settings of a preset, by its name. "balanced" and "calibrated" always exist: the calibration's
/// own. Errors: no study is stored; the preset improves nothing on this finger.
[[nodiscard]] Result<PipelineSettings> preset_settings(const std::filesystem::path& folder,
                                                       const std::string& name);

// The settings of a finger for all measurements.

/// Those of its calibration, with the changes of the preset in use (measuring_presets.h). An
/// unreadable preset file changes nothing.
[[nodiscard]] PipelineSettings measuring_settings(const std::filesystem::path& finger_folder);

/// The pipeline's settings in calibration_inputs.yaml: a mapping requires the smoothing, edges and
/// reference that its presses were measured with. contact_threshold_mm, which no mapping depends
/// on, has its default. Without a readable file (not calibrated): the default settings.
[[nodiscard]] PipelineSettings calibrated_settings(const std::filesystem::path& finger_folder);

}  // namespace alltact
