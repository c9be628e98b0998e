// Regular synchronisation of files to the disk while they are being written.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

namespace alltact {

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
  std::vector<int> descriptors_;  // of the files; -1: not there yet
  std::mutex mutex_;
  std::condition_variable ending_;
  bool is_ending_ = false;
  std::thread thread_;
};

}  // namespace alltact
