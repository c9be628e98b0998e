// Reports a disk that does not answer, as one in a network that stalls. A busy processor is no slow
// disk: only the time counts in which a thread neither runs nor queues for a processor.
#pragma once

#include "core/result.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

namespace alltact {

/// While it lives, its thread waits for a file; one within another is the outer one's. It stands
/// around system calls, not around work that other threads do: sleeping counts as waiting. Costs
/// next to nothing where nobody watches.
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
  /// `on_slow` is called on a thread of its own where a wait was blocked for longer than
  /// `timeout`, at most 1.25 times that after its begin: once for each disk and stall. `file` is
  /// final_path() of what is waited for.
  DiskWatch(std::chrono::milliseconds timeout,
            std::function<void(const std::filesystem::path& file)> on_slow);
  DiskWatch(const DiskWatch&) = delete;
  DiskWatch& operator=(const DiskWatch&) = delete;
  ~DiskWatch();
  /// final_path() of each file whose wait is blocked for longer than `timeout`, longest first.
  [[nodiscard]] std::vector<std::filesystem::path> slow() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// How long a disk may take to answer before a person hears of it.
inline constexpr std::chrono::seconds kDiskTimeout{3};

/// A disk that was reported is reported again only after it answered for so long.
inline constexpr std::chrono::minutes kDiskQuiet{10};

/// The message for a file that is waited for.
[[nodiscard]] Error slow_disk(const std::filesystem::path& file);

}  // namespace alltact
