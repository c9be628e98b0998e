// Files that are on the disk while they are still being written.
#pragma once

#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <mutex>
#include <thread>
#include <vector>

namespace alltact {

/// Makes sure, once in a while and on a thread of its own, that what was written to some files is
/// on the disk: without that a power cut may take all that was recorded in the last half minute, or
/// the file's name. Files that are not there yet are waited for; what cannot be synced is told by
/// whoever writes, at the end.
class SteadySync {
 public:
  /// In this order, so that what the second told of the first before a sync is there after it; what
  /// it tells while the first is synced may be ahead.
  SteadySync(std::vector<std::filesystem::path> files, std::chrono::milliseconds every);
  SteadySync(const SteadySync&) = delete;
  SteadySync& operator=(const SteadySync&) = delete;
  /// Waits for a sync that is under way.
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
