// What a finger measures with: settings with a name, found by a study of this finger and kept with
// it, and those it measures with from now on. measuring.yaml beside finger.yaml:
//   format: alltact-measuring/1
//   used: fast                        # name, or what was asked for; absent: as it was calibrated
//   used_settings: {reference-neighbours: 4}   # what differs from the calibration's
//   study: {date: "2026-01-31T12:00:00Z", program_version: 0.1.0, machine: ..., about: ...}
//   base: {edge-method: crossing, ...}  # the calibration's settings then
//   presets:
//     fast: {frame_ms: 1.1, median_mm: 0.012, p95_mm: 0.05, settings: {reference-neighbours: 4}}
// Settings stand there as differences, so that a finger that is calibrated anew with other settings
// keeps what its mapping holds for.
#pragma once

#include "core/finger/finger_store.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// Settings with a name, and what a study measured with them.
struct MeasuringPreset {
  std::string name;           ///< "fast", "balanced", "finest"
  PipelineSettings settings;  ///< whole: the calibration's with what differs
  double frame_ms = 0;        ///< median of a frame on that computer
  double median_mm = 0;       ///< of the error of depth
  double p95_mm = 0;
};

struct MeasuringPresets {
  static constexpr const char* kFormat = "alltact-measuring/1";

  // Of the study that found them; empty: none was kept.
  std::string date;             ///< UTC, as utc_now() writes it
  std::string program_version;  ///< that measured
  std::string machine;          ///< processor and number of threads
  std::string about;            ///< what was measured
  /// Only those that bring something on this finger.
  std::vector<MeasuringPreset> presets;
  /// The finger was calibrated with other settings than when it was studied: the presets can be
  /// used, their figures are old.
  bool is_stale = false;

  /// What the finger measures with now: a preset's name, or what was asked for ("within 5 ms");
  /// empty: as it was calibrated.
  std::string used;
  PipelineSettings now;         ///< those settings, whole
  PipelineSettings calibrated;  ///< and those of the calibration

  /// nullptr: there is none of this name.
  [[nodiscard]] const MeasuringPreset* find(const std::string& name) const;
};

/// What the finger keeps; nothing but `now` and `calibrated` where it keeps nothing. Errors: a file
/// that cannot be read or holds something impossible.
[[nodiscard]] Result<MeasuringPresets> presets_of_finger(const std::filesystem::path& folder);

/// Keeps the study's part (date to presets) in place of an earlier one; what the finger measures
/// with stays. `presets.calibrated` is taken as the settings that were studied from.
[[nodiscard]] Status keep_presets(FingerStore& store, const MeasuringPresets& presets);

/// The finger measures with these from now on, everywhere (measuring_settings.h): live,
/// reconstruct, check, in every window.
///   name: of the preset, or what was asked for in words; not empty
[[nodiscard]] Status use_settings(FingerStore& store,
                                  const PipelineSettings& settings,
                                  const std::string& name);
/// The way back: as it was calibrated.
[[nodiscard]] Status use_calibrated_settings(FingerStore& store);

/// Settings of a preset, by its name; "balanced" and "calibrated" are always there: the
/// calibration's own. Errors: no study was kept; the preset brings nothing on this finger.
[[nodiscard]] Result<PipelineSettings> preset_settings(const std::filesystem::path& folder,
                                                       const std::string& name);

}  // namespace alltact
