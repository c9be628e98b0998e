// Caches on disk for results that take long to compute.
#pragma once

#include "core/base/job.h"
#include "core/base/result.h"

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace alltact {

/// alltact/KIND below $XDG_CACHE_HOME, or below .cache of $HOME; nullopt: neither is an absolute
/// path, and nothing is cached.
[[nodiscard]] std::optional<std::filesystem::path> cache_folder(std::string_view kind);

/// Removes all entries of a cache but the `most` newest ones. Hidden entries, which are incomplete,
/// are removed after a day without a write. Entries that cannot be removed stay.
void remove_oldest(const std::filesystem::path& cache, std::size_t max_entries);

/// Checksum of the program or library that holds a function; empty where it cannot be read. It
/// identifies the code that made a cached result: a version does not change with every line of
/// code.
[[nodiscard]] std::string checksum_of_code(const void* function);

// Costly values that all users share, as long as anybody holds them.

/// Values by the key they were made from. A value lives as long as somebody holds it. Any thread.
template <class T>
class SharedValues {
 public:
  /// Returns the value for `key` that somebody holds, or else the one that `make` returns. While
  /// another thread makes it, waits for that thread; if that fails or is stopped, makes it itself.
  /// Errors: those of `make`, a function that returns a Result<std::shared_ptr<const T>>; `stopped`
  /// when the job was stopped while waiting.
  template <class Make>
  [[nodiscard]] Result<std::shared_ptr<const T>> get(const std::string& key, const Job& job,
                                                     const Error& stopped, Make make) {
    std::unique_lock lock(mutex_);
    erase_expired();
    while (values_[key].is_making) {
      if (job.stop_requested()) return stopped;
      made_.wait_for(lock, std::chrono::milliseconds(20));
    }
    if (auto there = values_[key].value.lock()) return there;
    values_[key].is_making = true;
    lock.unlock();
    const MakingGuard making(*this, key);
    Result<std::shared_ptr<const T>> value = make();
    if (value) {
      const std::lock_guard again(mutex_);
      values_[key].value = *value;
    }
    return value;
  }

 private:
  struct Entry {
    std::weak_ptr<const T> value;
    bool is_making = false;
  };
  /// Marks the entry as finished, also after an exception.
  struct MakingGuard {
    MakingGuard(SharedValues& all_values, std::string made_key)
        : all(all_values), key(std::move(made_key)) {}
    MakingGuard(const MakingGuard&) = delete;
    MakingGuard& operator=(const MakingGuard&) = delete;
    ~MakingGuard() {
      {
        const std::lock_guard lock(all.mutex_);
        all.values_[key].is_making = false;
      }
      all.made_.notify_all();
    }
    SharedValues& all;
    std::string key;
  };

  void erase_expired() {
    std::erase_if(values_, [](const auto& entry) {
      return !entry.second.is_making && entry.second.value.expired();
    });
  }

  std::mutex mutex_;
  std::condition_variable made_;
  std::map<std::string, Entry> values_;
};

}  // namespace alltact
