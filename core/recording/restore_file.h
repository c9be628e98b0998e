// Restores files that were removed while they are open.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <filesystem>

namespace alltact {

/// True when the open file is in no folder any more.
[[nodiscard]] bool is_removed(int descriptor);

/// Restores a removed file at its old path, with its folder. Disks that share blocks (btrfs, xfs)
/// do it at once. Otherwise it copies every byte, reports to the job, and ends within 16 MB of a
/// stop; the copied part remains. A job that was stopped before the call does not end it. Error: it
/// cannot be read or written there, another file exists, or stopped.
[[nodiscard]] Status restore_file(int descriptor,
                                  const std::filesystem::path& file,
                                  const Job& job);

}  // namespace alltact
