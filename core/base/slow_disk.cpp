#include "core/base/slow_disk.h"

#include "core/base/atomic_file.h"

#include <algorithm>
#include <atomic>
#include <cassert>
#include <cinttypes>
#include <condition_variable>
#include <cstdio>
#include <fstream>
#include <map>
#include <mutex>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <pthread.h>
#include <time.h>
#include <unistd.h>

namespace alltact {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using std::chrono::nanoseconds;

/// A thread within this process.
struct ThreadId {
  pid_t number = ::gettid();
  pthread_t handle = ::pthread_self();
};

/// Use of the processor by a thread until now.
struct ThreadUse {
  nanoseconds on_processor{0};  ///< running or queued, as far as the system counts both
  bool is_blocked = true;       ///< neither runs nor queues at this moment
};

/// Text of a small file in /proc; empty where it is absent.
std::string proc_text(const ThreadId& thread, const char* name) {
  std::FILE* file =
      std::fopen(fmt::format("/proc/self/task/{}/{}", thread.number, name).c_str(), "re");
  if (file == nullptr) return {};
  char text[512];
  const std::size_t size = std::fread(text, 1, sizeof text, file);
  std::fclose(file);
  return {text, size};
}

/// Source: proc(5) for `stat`, Documentation/scheduler/sched-stats.rst of Linux for `schedstat`
/// (nanoseconds run, nanoseconds queued, turns). A kernel may leave out either.
ThreadUse use_of(const ThreadId& thread) {
  ThreadUse use;
  std::uint64_t run = 0, queued = 0;
  if (std::sscanf(proc_text(thread, "schedstat").c_str(), "%" SCNu64 " %" SCNu64, &run, &queued) ==
      2) {
    use.on_processor = nanoseconds(run + queued);
  } else {
    clockid_t clock = 0;
    timespec time{};
    if (::pthread_getcpuclockid(thread.handle, &clock) == 0 && ::clock_gettime(clock, &time) == 0)
      use.on_processor = std::chrono::seconds(time.tv_sec) + nanoseconds(time.tv_nsec);
  }
  // "NUMBER (NAME) STATE ...", where NAME may hold anything.
  const std::string stat = proc_text(thread, "stat");
  const std::size_t name_end = stat.rfind(") ");
  // A queue that lasts until now is counted only at its end: R shows that it lasts.
  if (name_end != std::string::npos && name_end + 2 < stat.size())
    use.is_blocked = std::string_view("RTt").find(stat[name_end + 2]) == std::string_view::npos;
  return use;
}

struct Wait {
  fs::path file;
  ThreadId thread;
  std::optional<ThreadUse> last_use;  ///< empty until the watch first sees it
  Clock::time_point last_seen;
  nanoseconds blocked{0};
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

/// Adds the time since the last call, at most `limit`. In a stopped program, or with a delayed
/// watch thread, the time between is unknown.
void update(Wait& wait, nanoseconds limit) {
  const ThreadUse use = use_of(wait.thread);
  const auto now = Clock::now();
  if (wait.last_use && use.is_blocked) {
    const nanoseconds passed = std::min<nanoseconds>(now - wait.last_seen, limit);
    wait.blocked +=
        std::max(nanoseconds(0), passed - (use.on_processor - wait.last_use->on_processor));
  }
  wait.last_use = use;
  wait.last_seen = now;
}

/// Mount point of the disk that holds `file`, without access to either, because both may stall.
std::string mount_point_of(const fs::path& file) {
  std::error_code ignored;
  const fs::path full = fs::absolute(file, ignored).lexically_normal();
  std::ifstream mounts("/proc/self/mountinfo");
  std::string line, best = "/";
  while (std::getline(mounts, line)) {
    std::istringstream words(line);
    std::string word, mount_point;
    // Source: proc(5): number, parent, device, root, mount point.
    words >> word >> word >> word >> word >> mount_point;
    const fs::path point(mount_point);
    const bool holds_file =
        std::mismatch(point.begin(), point.end(), full.begin(), full.end()).first == point.end();
    if (holds_file && mount_point.size() > best.size()) best = mount_point;
  }
  return best;
}

}  // namespace

DiskWait::DiskWait(const fs::path& file) {
  if (!is_watched || outermost != nullptr) return;
  outermost = this;
  const std::lock_guard lock(mutex());
  Wait& wait = waits()[this];
  wait.file = file;
}

DiskWait::~DiskWait() {
  if (outermost != this) return;
  outermost = nullptr;
  const std::lock_guard lock(mutex());
  waits().erase(this);
}

struct DiskWatch::State {
  std::chrono::milliseconds timeout;
  std::function<void(const fs::path&)> on_slow;
  std::map<std::string, Clock::time_point> last_slow;  ///< by mount point
  Worker worker;                                       // last: it ends first

  void run(const std::stop_token& stop) {
    const auto poll_interval = timeout / 8;
    while (!is_stopped_within(stop, poll_interval))
      for (const fs::path& file : update_all(2 * poll_interval)) report(file);
  }

  /// The files that are slow now. A report may block where nobody reads it: without the mutex.
  [[nodiscard]] std::vector<fs::path> update_all(std::chrono::milliseconds longest) const {
    const std::lock_guard lock(mutex());
    for (auto& [key, wait] : waits()) update(wait, longest);
    return slow_files();
  }

  /// With the mutex held.
  [[nodiscard]] std::vector<fs::path> slow_files() const {
    std::vector<const Wait*> found;
    for (const auto& [key, wait] : waits())
      if (wait.blocked >= timeout) found.push_back(&wait);
    std::stable_sort(found.begin(), found.end(), [](const Wait* one, const Wait* other) {
      return std::tie(other->blocked, one->file) < std::tie(one->blocked, other->file);
    });
    std::vector<fs::path> files;
    for (const Wait* wait : found) {
      fs::path file = final_path(wait->file);
      if (std::find(files.begin(), files.end(), file) == files.end())
        files.push_back(std::move(file));
    }
    return files;
  }

  void report(const fs::path& file) {
    const auto now = Clock::now();
    const auto [disk, is_first] = last_slow.try_emplace(mount_point_of(file), now);
    const bool is_new = is_first || now - disk->second > kDiskQuiet;
    disk->second = now;
    if (is_new) static_cast<void>(guarded([&] { on_slow(file); }));  // the next report may succeed
  }
};

DiskWatch::DiskWatch(std::chrono::milliseconds timeout,
                     std::function<void(const fs::path&)> on_slow)
    : state_(std::make_unique<State>()) {
  state_->timeout = timeout;
  state_->on_slow = std::move(on_slow);
  assert(!is_watched);
  is_watched = true;
  state_->worker = Worker([s = state_.get()](const std::stop_token& stop) { s->run(stop); });
}

DiskWatch::~DiskWatch() {
  const std::lock_guard lock(mutex());
  is_watched = false;
  waits().clear();
}

std::vector<fs::path> DiskWatch::slow() const {
  const std::lock_guard lock(mutex());
  return state_->slow_files();
}

Error slow_disk(const fs::path& file) {
  return {en::say("its disk responds slowly; waiting for it"), file.string(),
          en::say("wait; if it lasts, check whether another program keeps that disk busy, then its "
                  "network or cable")};
}

DiskQueue::DiskQueue() : worker_([this](const std::stop_token& stop) { work(stop); }) {}

void DiskQueue::add(fs::path file, Task task) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back({std::move(file), std::move(task)});
  changed_.notify_all();
}

void DiskQueue::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return tasks_.empty() && !is_busy_; });
}

std::optional<Error> DiskQueue::problem() const {
  const std::lock_guard lock(mutex_);
  return problems_.empty() ? std::nullopt : std::optional(problems_.back().error);
}

void DiskQueue::clear_problem() {
  const std::lock_guard lock(mutex_);
  problems_.clear();
}

void DiskQueue::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, stop, [this] { return !tasks_.empty(); });
    if (tasks_.empty()) return;
    const auto [file, task] = std::move(tasks_.front());
    tasks_.pop_front();
    is_busy_ = true;
    lock.unlock();
    const Status status = guarded(task);
    lock.lock();
    is_busy_ = false;
    std::erase_if(problems_, [&, &done = file](const Failed& one) { return one.file == done; });
    if (!status) problems_.push_back({file, status.error()});
    changed_.notify_all();
  }
}

}  // namespace alltact
