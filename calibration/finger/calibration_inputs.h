// What a calibration was made from, kept beside finger.yaml so that it can be made again.
//
// calibration_inputs.yaml, with the pictures in presses/ and the finger's own reference, is all
// that a repetition needs:
//   format: alltact-calibration/1
//   date: "2026-01-31T12:00:00Z"      # of the calibration, not of its repetition
//   program_version: 0.1.0
//   operator: Ada                     # this, the radius and what was said of single presses
//                                     # then: as in press_notes.yaml (press_set.h)
//   ball_radius_mm: 4.0
//   calibration: {method: joint, ...} # the settings, by their names
//   pipeline: {edge-method: crossing, ...}
//   continuous: false                 # markers were followed from press to press
//   finger: 0123456789abcdef          # checksums: camera, face and markers; the reference's files
//   reference: 0123456789abcdef
//   excluded: [press_3]
//   excluded_because: [glove in the picture]
//   checksums: [0123456789abcdef, ...]  # of every press' pixels
//   presses: [press_0, ...]           # presses/NAME.png, in this order; last, in brackets, so
//                                     # that a file that was cut off is no YAML
#pragma once

#include "calibration/joint/calibrate.h"
#include "core/finger/finger.h"
#include "core/finger/press_set.h"
#include "core/message.h"
#include "core/result.h"
#include "core/sensing/pipeline_settings.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// Where a finger keeps the pictures of its presses.
inline constexpr const char* kPressFolder = "presses";

/// A picture in presses/.
struct KeptPress {
  std::string name;      ///< its file's, without the ending
  std::string checksum;  ///< of its pixels, see picture_checksum
};

struct CalibrationInputs {
  static constexpr const char* kFormat = "alltact-calibration/1";
  static constexpr const char* kFileName = "calibration_inputs.yaml";

  std::string date;             ///< UTC, as utc_now() writes it
  std::string program_version;  ///< that solved
  PressSet said;                ///< of the presses, then; names none but these
  CalibrationSettings calibration;
  PipelineSettings pipeline;
  bool is_continuous = false;
  std::string finger_checksum, reference_checksum;
  std::vector<KeptPress> presses;

  /// Strict in values, kind to unknown keys, which are kept and named in `warnings`, as
  /// Finger::load is. Errors: no such file, another format, anything missing or impossible.
  static Result<CalibrationInputs> load(const std::filesystem::path& finger_folder,
                                        std::vector<Message>* warnings = nullptr);
  static Result<CalibrationInputs> parse(const std::string& yaml,
                                         const std::filesystem::path& origin,
                                         std::vector<Message>* warnings = nullptr);
  [[nodiscard]] std::string to_yaml() const;

 private:
  struct Unknown;
  std::shared_ptr<const Unknown> unknown_;
};

/// The pictures in presses/ of a finger's folder, in name order; none where there is no such
/// folder.
[[nodiscard]] Result<std::vector<std::filesystem::path>> kept_presses(
    const std::filesystem::path& finger_folder);

/// True when the same calibration comes out: everything but the date is equal.
[[nodiscard]] bool same_but_for_date(const CalibrationInputs& a, const CalibrationInputs& b);

/// Sixteen hexadecimal digits that tell pictures apart that differ by accident (FNV-1a over words
/// of 64 bits); not a protection against intent.
[[nodiscard]] std::string picture_checksum(const cv::Mat& grey);
/// Of what a finger was before anything was calibrated: camera, face, markers.
[[nodiscard]] std::string finger_checksum(const Finger& finger);
/// Of the files that the finger names as its reference (of a picture its pixels); empty when it
/// names none.
[[nodiscard]] Result<std::string> reference_checksum(const std::filesystem::path& finger_folder,
                                                     const Finger& finger);

/// A word as a POSIX shell reads it back.
[[nodiscard]] std::string shell_quoted(std::string_view word);

}  // namespace alltact
