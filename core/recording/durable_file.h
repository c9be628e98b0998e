// Restores files that were removed while they are open.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/worker.h"

#include <chrono>
#include <filesystem>
#include <vector>

namespace alltact {

/// True when the open file is in no folder any more.
[[nodiscard]] bool is_removed(int descriptor);

/// Restores a removed file at its old path, with its folder. Disks that share blocks (btrfs, xfs)
/// do it at once. Otherwise it copies every byte, reports to the job, and ends within 16 MB of a
/// stop; the copied part remains. A job that was stopped before the call does not end it. Error: it
/// cannot be read or written there, another file exists, or stopped.
[[nodiscard]] Status restore_file(int descriptor, const std::filesystem::path& file,
                                  const Job& job);

// Regular synchronisation of files to the disk while they are being written.

/// Syncs files to the disk at regular intervals, on a thread of its own. Otherwise a power cut may
/// lose the last half minute, or the file's name. It waits for files that do not exist yet. The
/// writer reports failures at its end.
class SteadySync {
 public:
  /// Files are synced in this order. A later file's entries about an earlier one are valid up to
  /// the previous sync; newer entries may be ahead.
  SteadySync(std::vector<std::filesystem::path> files, std::chrono::milliseconds every);
  SteadySync(const SteadySync&) = delete;
  SteadySync& operator=(const SteadySync&) = delete;
  ~SteadySync() = default;  ///< waits for a running sync

 private:
  void sync();

  const std::vector<std::filesystem::path> files_;
  std::vector<Descriptor> descriptors_;  // of the files; not open: not there yet
  Worker worker_;                        // last: it ends first
};

}  // namespace alltact
