// Which part of a recording a run of `alltact reconstruct` measures.
#pragma once

#include "app/commands/commands.h"
#include "core/batch/parts.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <string>

namespace alltact {

/// Two runs of one name give the same results: same program, finger, settings, files asked for, and
/// inputs by name and number of frames.
[[nodiscard]] std::string name_of_run(const ReconstructOptions& options, std::size_t frame_count);

/// The frames that are asked for. Error: a part of what has no known number of frames, or is not
/// measured in parts.
[[nodiscard]] Result<BatchFrames> frames_asked(const ReconstructOptions& options,
                                               const Source& source,
                                               const Pipeline& pipeline);

}  // namespace alltact
