// What was said of a finger's presses while they are being collected: press_notes.yaml, beside
// presses/. A calibration keeps its own in calibration_inputs.yaml.
//   format: alltact-press-notes/1
//   ball_radius_mm: 4.0               # absent: not told yet
//   operator: Ada                     # absent: not told
//   other_balls: [press_5]            # these as in calibration_inputs.yaml
//   other_balls_mm: [6.0]
//   depths: [press_2]
//   depths_mm: [[1.2, 0.01]]
//   steps: [press_7]
//   steps_mm: [0.5]
//   balls: [press_4]
//   balls_mm: [[1.5, -2.0, 48.0]]
//   excluded: [press_3]
//   excluded_because: [glove in the picture]
#pragma once

#include "calibration/finger/calibration_inputs.h"
#include "core/result.h"

#include <filesystem>
#include <string>
#include <vector>

namespace alltact {

struct PressNotes : SaidOfPresses {
  static constexpr const char* kFormat = "alltact-press-notes/1";
  static constexpr const char* kFileName = "press_notes.yaml";

  std::string operator_name;  ///< empty: not told
  bool operator==(const PressNotes&) const = default;

  [[nodiscard]] static PressNotes of(const CalibrationInputs& inputs);

  /// What was said last: this file, or the inputs of a calibration that was made since. Empty
  /// where neither is there. Errors: those of reading the one that counts.
  static Result<PressNotes> load(const std::filesystem::path& finger_folder);
  static Result<PressNotes> parse(const std::string& yaml, const std::filesystem::path& origin);
  [[nodiscard]] std::string to_yaml() const;
  /// Whole or not at all.
  [[nodiscard]] Status save(const std::filesystem::path& finger_folder) const;
};

/// The pictures in presses/ of a finger's folder, in name order; none where there is no such
/// folder.
[[nodiscard]] Result<std::vector<std::filesystem::path>> kept_presses(
    const std::filesystem::path& finger_folder);

}  // namespace alltact
