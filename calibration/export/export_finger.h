// Exports a finger's calibration for other programs, alike from the window and the command line.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"
#include "core/finger/finger_store.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

enum class ExportForm { kOpencv = 1, kRos, kJson, kZip };

/// A form, its files and its name on the command line.
struct ExportFormInfo {
  ExportForm form;
  std::string_view word;   ///< "opencv"
  std::string_view files;  ///< "camera.opencv.yaml"
};
/// All forms, in the order in which they are written.
[[nodiscard]] const std::vector<ExportFormInfo>& export_forms();
[[nodiscard]] std::optional<ExportForm> export_form_from(std::string_view word);

/// The command that writes the same files in a terminal.
[[nodiscard]] std::string export_command(const std::filesystem::path& finger_folder,
                                         const std::vector<ExportForm>& forms,
                                         const std::filesystem::path& folder);

/// Recordings in the finger's folder that are not its reference: videos with the journal of their
/// recording. In the order of their names.
[[nodiscard]] std::vector<std::filesystem::path> unused_recordings(
    const Finger& finger, const std::filesystem::path& finger_folder);

/// Writes these forms to `folder`, which is created if missing. Files of an earlier export are
/// replaced atomically.
///   opencv  camera.opencv.yaml: camera matrix and distortion, for cv::FileStorage
///   ros     camera_info.yaml, as camera_calibration_parsers reads it, and parameters.yaml for a
///           ROS 2 node: face, markers, mapping, with the units in the names
///   json    calibration.json: all inputs of a measurement but the reference images
///   zip     finger.zip: calibration.json and, below finger/, every file of the finger's folder but
///           unused_recordings(); the same finger gives the same bytes
/// Pixels are those of the image after the camera's orientation. Nothing is written when one of the
/// forms cannot express the finger (an orthographic camera or one behind a window has no camera
/// matrix), or a zip would lie in the finger's folder. Other errors: a disk that cannot be read or
/// written, stopped by `job`; files written before stay. `written`: may be null; the files that
/// exist, also when an error is returned.
[[nodiscard]] Status export_finger(const FingerSnapshot& snapshot,
                                   const std::vector<ExportForm>& forms,
                                   const std::filesystem::path& folder, const Job& job,
                                   std::vector<std::filesystem::path>* written);

}  // namespace alltact
