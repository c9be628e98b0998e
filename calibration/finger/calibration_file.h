// calibration.yaml: the calibration that a finger holds, for its own program. The mapping and its
// record are in finger.yaml, its inputs in calibration_inputs.yaml.
//
//   format: alltact-finger-calibration/1
//   residual_mm: 0.0041               # as in the record of finger.yaml
//   condition: 184.2
//   degree_choice: "{\"say\": ...}"   # sentences as message_json(), so that they can be translated
//   left_out: [...]
//   remarks: [...]
//   fault_signs: [...]
//   about_settings: [...]
//   next_press: {enough: false, along_mm: 8.1, ..., sentence: ...}
//   halo: {near_mm: 0.01, ..., is_seen: false}
//   steps:                            # punches with a step
//     - {press: press_7, step_mm: 0.5, reads_mm: 0.49, sd_mm: 0.01}
//   bodies:                           # other bodies of known shape: depth read / true depth
//     - {press: press_8, body: rod.stl, scale: 1.004, sd: 0.006}
//   presses:                          # balls; last, so that a truncated file lacks some
//     - {press: press_0, ball_radius_mm: 4.0, centre_mm: [...], ..., samples: "u v x ..."}
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "core/base/result.h"

#include <filesystem>
#include <string>

namespace alltact {

inline constexpr const char* kCalibrationFile = "calibration.yaml";

/// The content of the file. Samples of the residuals have five significant digits; of more than
/// 50,000 every second, third, ... is stored, so that the file stays below 4 MB. The same
/// calibration gives the same bytes.
[[nodiscard]] std::string calibration_yaml(const FingerCalibration& done);

/// Fills the calibration's balls, steps, bodies, sentences and figures, residuals, halo,
/// fault_signs and about_settings; all else stays empty. Errors: another format; anything missing
/// or impossible.
[[nodiscard]] Result<FingerCalibration> parse_calibration(const std::string& yaml,
                                                          const std::filesystem::path& origin);

/// The calibration of a finger as its folder holds it: nothing is measured or solved. Empty stay
/// the presses' images, the comparison with other methods, and details of calibrate() (weakest,
/// radius_sensitivity). Errors: the finger is not calibrated; a file is missing or unreadable, as
/// of a finger that an earlier version calibrated; the file belongs to another calibration than
/// finger.yaml.
[[nodiscard]] Result<FingerCalibration> stored_calibration(const std::filesystem::path& folder);

}  // namespace alltact
