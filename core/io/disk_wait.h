// Whoever waits for a disk that does not answer, as one in a network that stalls, is told so.
#pragma once

#include "core/result.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

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
  /// What is waited for longer than `patience` now, in the order of its names.
  [[nodiscard]] std::vector<std::filesystem::path> slow() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// How long a person waits for a disk without being told.
inline constexpr std::chrono::seconds kDiskPatience{3};

/// What to say of a file that is waited for.
[[nodiscard]] Error slow_disk(const std::filesystem::path& file);

}  // namespace alltact
