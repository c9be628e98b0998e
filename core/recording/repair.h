// Repair of recordings that a crash interrupted.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// Adds index and length to a recording that was never finished (killed program, full disk), so
/// that any player can seek in it. Packets are copied unchanged to a temporary file in the same
/// folder. That file replaces the old one when it is complete and on the disk. A remark in the
/// journal reports frames that the journal has and the file lacks. Only files written by
/// VideoWriter are changed, and none that is being written. True: repaired; false: no repair was
/// necessary. Errors: it is being recorded right now, no space for a copy, folder read-only; the
/// recording stays readable.
[[nodiscard]] Result<bool> repair_recording(const std::filesystem::path& file, const Job& job);

}  // namespace alltact
