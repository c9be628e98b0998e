// The part of a recording that a run of `alltact reconstruct` measures.
#pragma once

#include "app/commands/commands.h"
#include "core/batch/parts.h"
#include "core/sensing/pipeline.h"
#include "core/sources/source.h"

#include <string>

namespace alltact {

/// Runs with the same name give the same results: same program, finger, settings, requested files,
/// and inputs by name and number of frames.
[[nodiscard]] std::string name_of_run(const ReconstructOptions& options, std::size_t frame_count);

/// The requested frames. Error: a part of a source without a known number of frames, or of one that
/// cannot be split.
[[nodiscard]] Result<BatchFrames> requested_frames(const ReconstructOptions& options,
                                                   const Source& source,
                                                   const Pipeline& pipeline);

}  // namespace alltact
