// Inputs of a calibration, stored next to finger.yaml so that it can be repeated.
//
// calibration_inputs.yaml, with the images in presses/ and the finger's own reference, is all that
// a repetition needs:
//   format: alltact-calibration/1
//   date: "2026-01-31T12:00:00Z"      # of the calibration, not of its repetition
//   program_version: 0.1.0
//   operator: Ada                     # this, the radius and the notes on single presses at that
//                                     # time: as in press_notes.yaml (press_set.h)
//   ball_radius_mm: 4.0
//   calibration: {method: joint, ...} # the settings, by their names
//   pipeline: {edge-method: crossing, ...}
//   continuous: false                 # markers were followed from press to press
//   finger: 0123456789abcdef          # checksums: camera, face and markers; the reference's files
//   reference: 0123456789abcdef
//   excluded: [press_3]
//   excluded_because: [glove in the image]
//   checksums: [0123456789abcdef, ...]  # of every press' pixels
//   presses: [press_0, ...]           # presses/NAME.png, in this order; last, in brackets, so
//                                     # that a truncated file is no YAML
#pragma once

#include "calibration/joint/calibrate.h"
#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/yaml.h"
#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "core/image/frame.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Folder of a finger's press images.
inline constexpr const char* kPressFolder = "presses";

/// An image in presses/.
struct StoredPress {
  std::string name;      ///< file name without the ending
  std::string checksum;  ///< of its pixels, see image_checksum
};

struct CalibrationInputs {
  static constexpr const char* kFormat = "alltact-calibration/1";
  static constexpr const char* kFileName = "calibration_inputs.yaml";

  std::string date;             ///< UTC, as utc_now() writes it
  std::string program_version;  ///< that solved
  PressSet press_set;           ///< of the presses, at that time; names none but these
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  bool is_continuous = false;
  std::string finger_checksum, reference_checksum;
  std::vector<StoredPress> presses;

  /// Strict in values. Unknown keys are preserved and named in `warnings`, as in Finger::load.
  /// Errors: no such file; another format; anything missing or impossible.
  static Result<CalibrationInputs> load(const std::filesystem::path& finger_folder,
                                        std::vector<Message>* warnings = nullptr);
  static Result<CalibrationInputs> parse(const std::string& yaml,
                                         const std::filesystem::path& origin,
                                         std::vector<Message>* warnings = nullptr);
  [[nodiscard]] std::string to_yaml() const;

 private:
  UnknownKeys unknown_;
};

/// The file of a stored press.
[[nodiscard]] std::filesystem::path stored_press_file(const std::filesystem::path& finger_folder,
                                                      const std::string& name);
/// Writes a frame there, with its settings. The folder is created if missing.
[[nodiscard]] Status store_press(const std::filesystem::path& finger_folder, const Frame& frame);
/// Reads it, without its settings.
[[nodiscard]] Result<FramePtr> read_stored_press(const std::filesystem::path& finger_folder,
                                                 const std::string& name);

/// The images in presses/ of a finger's folder, in name order; empty where there is no such folder.
[[nodiscard]] Result<std::vector<std::filesystem::path>> stored_presses(
    const std::filesystem::path& finger_folder);

/// True when the same calibration comes out: everything but the date is equal.
[[nodiscard]] bool same_but_for_date(const CalibrationInputs& a, const CalibrationInputs& b);

/// Sixteen hexadecimal digits that distinguish images with accidental differences (FNV-1a over
/// words of 64 bits); no protection against intent.
[[nodiscard]] std::string image_checksum(const cv::Mat& grey);
/// Of a finger's fields before any calibration: camera, face, markers.
[[nodiscard]] std::string finger_checksum(const Finger& finger);
/// Of the finger's reference files (of an image its pixels); empty without a reference.
[[nodiscard]] Result<std::string> reference_checksum(const std::filesystem::path& finger_folder,
                                                     const Finger& finger);

/// A word as a POSIX shell reads it back.
[[nodiscard]] std::string shell_quoted(std::string_view word);

}  // namespace alltact
