// Costly values that all who need them share, as long as anybody does.
#pragma once

#include "core/job.h"
#include "core/result.h"

#include <chrono>
#include <condition_variable>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

namespace alltact {

/// Values by what they were made from. A value lives as long as somebody holds it. Any thread.
template <class T>
class SharedValues {
 public:
  /// The value for `key` that somebody holds or, where nobody does, what `make` gives. While
  /// another thread makes it, waits for that one; where that fails or was stopped, makes it itself.
  /// Errors: those of `make`, a function that gives a Result<std::shared_ptr<const T>>; `stopped`
  /// when the job was asked to stop while waiting.
  template <class Make>
  [[nodiscard]] Result<std::shared_ptr<const T>> get(const std::string& key,
                                                     const Job& job,
                                                     const Error& stopped,
                                                     Make make) {
    std::unique_lock lock(mutex_);
    forget_gone();
    while (values_[key].is_making) {
      if (job.stop_requested()) return stopped;
      made_.wait_for(lock, std::chrono::milliseconds(20));
    }
    if (auto there = values_[key].value.lock()) return there;
    values_[key].is_making = true;
    lock.unlock();
    const Making making(*this, key);
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
  /// Ends however the making ends.
  struct Making {
    Making(SharedValues& all, std::string key) : all(all), key(std::move(key)) {}
    Making(const Making&) = delete;
    Making& operator=(const Making&) = delete;
    ~Making() {
      {
        const std::lock_guard lock(all.mutex_);
        all.values_[key].is_making = false;
      }
      all.made_.notify_all();
    }
    SharedValues& all;
    std::string key;
  };

  void forget_gone() {
    std::erase_if(values_, [](const auto& entry) {
      return !entry.second.is_making && entry.second.value.expired();
    });
  }

  std::mutex mutex_;
  std::condition_variable made_;
  std::map<std::string, Entry> values_;
};

}  // namespace alltact
