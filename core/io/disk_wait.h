// Whoever waits for a disk that does not answer, as one in a network that stalls, is told so.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>

namespace alltact {

/// While it lives, its thread waits for a file; one within another is the outer one's. Costs next
/// to nothing where nobody watches.
class DiskWait {
 public:
  explicit DiskWait(const std::filesystem::path& file);
  DiskWait(const DiskWait&) = delete;
  DiskWait& operator=(const DiskWait&) = delete;
  ~DiskWait();
};

/// Watches all DiskWaits of the program while it lives; one at a time.
class DiskWatch {
 public:
  /// `on_slow` is called on a thread of its own, once for each wait that takes longer than
  /// `patience`.
  DiskWatch(std::chrono::milliseconds patience,
            std::function<void(const std::filesystem::path& file)> on_slow);
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;
  ~DiskWatch();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace alltact
