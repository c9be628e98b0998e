#include "core/io/disk_wait.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <condition_variable>
#include <map>
#include <mutex>
#include <thread>

namespace alltact {
namespace {

using Clock = std::chrono::steady_clock;

struct Wait {
  std::filesystem::path file;
  Clock::time_point since;
  bool is_told = false;
};

std::mutex& mutex() {
  static std::mutex one;
  return one;
}
/// With the mutex held.
std::map<const DiskWait*, Wait>& waits() {
  static std::map<const DiskWait*, Wait> all;
  return all;
}
std::atomic<bool> is_watched{false};
thread_local const DiskWait* outermost = nullptr;

}  // namespace

DiskWait::DiskWait(const std::filesystem::path& file) {
  if (!is_watched || outermost != nullptr) return;
  outermost = this;
  const std::lock_guard lock(mutex());
  waits()[this] = {file, Clock::now()};
}

DiskWait::~DiskWait() {
  if (outermost != this) return;
  outermost = nullptr;
  const std::lock_guard lock(mutex());
  waits().erase(this);
}

struct DiskWatch::State {
  std::chrono::milliseconds patience;
  std::function<void(const std::filesystem::path&)> on_slow;
  std::condition_variable ending;
  bool is_ending = false;
  std::thread thread;

  void run() {
    std::unique_lock lock(mutex());
    while (!ending.wait_for(lock, patience / 4, [&] { return is_ending; })) {
      for (auto& [key, wait] : waits()) {
        if (wait.is_told || Clock::now() - wait.since < patience) continue;
        wait.is_told = true;
        on_slow(wait.file);
      }
    }
  }
};

DiskWatch::DiskWatch(std::chrono::milliseconds patience,
                     std::function<void(const std::filesystem::path&)> on_slow)
    : state_(std::make_unique<State>()) {
  state_->patience = patience;
  state_->on_slow = std::move(on_slow);
  assert(!is_watched);
  is_watched = true;
  state_->thread = std::thread([s = state_.get()] { s->run(); });
}

DiskWatch::~DiskWatch() {
  {
    const std::lock_guard lock(mutex());
    state_->is_ending = true;
    is_watched = false;
    waits().clear();
  }
  state_->ending.notify_all();
  state_->thread.join();
}

std::vector<std::filesystem::path> DiskWatch::slow() const {
  std::vector<std::filesystem::path> files;
  const std::lock_guard lock(mutex());
  for (const auto& [key, wait] : waits())
    if (Clock::now() - wait.since >= state_->patience) files.push_back(wait.file);
  std::sort(files.begin(), files.end());
  files.erase(std::unique(files.begin(), files.end()), files.end());
  return files;
}

Error slow_disk(const std::filesystem::path& file) {
  return {en::say("its disk takes long to answer and is waited for"),
          file.string(),
          en::say("wait; where it lasts, look after the network or the cable of that disk")};
}

}  // namespace alltact
