// Files that were removed while they are open.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// True when no folder holds the open file any more.
[[nodiscard]] bool is_removed(int descriptor);

/// Brings what a removed file holds back to where it was, making its folder anew: at once where the
/// disk can share (btrfs, xfs), else as a copy of every byte, which takes the disk's time, is
/// reported to the job and ends within 16 MB of a stop; what was copied by then stays. A job that
/// was stopped before does not end it. Error: it cannot be read or written there, there is another
/// file by now, or stopped.
[[nodiscard]] Status put_back(int descriptor, const std::filesystem::path& file, const Job& job);

}  // namespace alltact
