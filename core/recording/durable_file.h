// Restores files that were removed while they are open.
#pragma once

#include "core/base/descriptor.h"
#include "core/base/job.h"
#include "core/base/result.h"

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
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
  /// Waits for a running sync.
  ~SteadySync();

 private:
  void run();
  void sync();

  const std::vector<std::filesystem::path> files_;
  const std::chrono::milliseconds every_;
  std::vector<Descriptor> descriptors_;  // of the files; not open: not there yet
  std::mutex mutex_;
  std::condition_variable ending_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace alltact
