// What the window and the command line do with fingers in exactly the same way.
#pragma once

#include "calibration/lens/calibrate_lens.h"
#include "calibration/reference/reference_recording.h"
#include "core/finger/finger.h"
#include "core/finger/new_finger.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// Makes a finger folder and gives what lies in it. Errors: there is a finger already; the camera
/// file or a value is wrong; the folder cannot be written.
[[nodiscard]] Result<Finger> make_finger(const NewFinger& wanted);

/// Installs a recording as a Fin Ray finger's reference and saves the finger. Errors: those of
/// open_source, install_reference and Finger::save.
[[nodiscard]] Result<ReferenceReport> install_recording(
    const std::filesystem::path& folder,
    Finger& finger,
    const std::vector<std::filesystem::path>& inputs,
    const Job& job,
    const ReferenceChoices& choices = {});

/// The command line that belongs to this program: beside it, or in the folder above while
/// developing. Empty: it is in neither.
[[nodiscard]] std::filesystem::path find_command_line();

/// Finds the board in all pictures and calibrates the lens. Errors: those of open_source,
/// find_boards and calibrate_lens.
[[nodiscard]] Result<LensCalibration> measure_lens(const std::vector<std::filesystem::path>& inputs,
                                                   const Board& board,
                                                   const LensSettings& settings,
                                                   const Job& job);

/// How a lens was measured, for the camera file.
[[nodiscard]] LensRecord lens_record(const Board& board, const LensCalibration& done);

/// A file of the resources, "scenes/NAME.yaml": beside the program once installed, in the source
/// tree while developing. Error: it is in neither.
[[nodiscard]] Result<std::filesystem::path> find_resource(const std::filesystem::path& name);

}  // namespace alltact
