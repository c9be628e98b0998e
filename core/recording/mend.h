// Recordings that a crash cut off, made whole again.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// Gives a recording that was never finished (the program was killed, the disk was full) its index
/// and its length, so that any player can seek in it. Its packets are copied as they are into a
/// file beside it, which takes its place when it is whole and on the disk; until then the old one
/// stays. Frames that the journal tells of and the file does not hold are named there in a remark.
/// Only files written by VideoWriter are touched, and none that is being written.
/// True: mended; false: there was nothing to mend. Errors: it is being recorded right now, no
/// space for a copy, folder read-only; the recording stays readable as it was.
[[nodiscard]] Result<bool> mend_recording(const std::filesystem::path& file, const Job& job);

}  // namespace alltact
