// A lens calibration from files, and its record.
#pragma once

#include "calibration/lens/calibrate_lens.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/result.h"

#include <filesystem>
#include <vector>

namespace alltact {

/// Finds the board in all images and calibrates the lens. Errors: those of open_source, find_boards
/// and calibrate_lens.
[[nodiscard]] Result<LensCalibration> measure_lens(const std::vector<std::filesystem::path>& inputs,
                                                   const Board& board,
                                                   const LensSettings& settings,
                                                   const Job& job);

/// How a lens was measured, for the camera file.
[[nodiscard]] LensRecord lens_record(const Board& board, const LensCalibration& done);

}  // namespace alltact
