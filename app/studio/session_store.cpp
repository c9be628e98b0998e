#include "app/studio/session_store.h"

#include "core/io/atomic_file.h"

#include <chrono>

namespace alltact {
namespace {

constexpr const char* kSession = "session.json";
constexpr const char* kLock = "running.lock";
constexpr std::size_t kLargestSession = std::size_t{1} << 20;
constexpr std::chrono::milliseconds kGather{300};

}  // namespace

SessionStore::SessionStore(std::filesystem::path folder)
    : folder_(std::move(folder)), lock_(QString::fromStdString((folder_ / kLock).string())) {
  if (const Status made = make_folder(folder_); !made) problem_ = made.error();
  std::error_code ignored;
  const bool was_left = std::filesystem::exists(folder_ / kLock, ignored);
  lock_.setStaleLockTime(0);  // only a running program holds it
  const bool has_lock = lock_.tryLock(0);
  has_crashed_ = was_left && has_lock;
  if (const auto text = read_file(folder_ / kSession, kLargestSession)) {
    auto state = session_from_json(*text, (folder_ / kSession).string());
    if (state) last_ = std::move(*state);
  }
  if (!last_) has_crashed_ = false;
  if (has_lock) thread_ = std::jthread([this](const std::stop_token& stop) { write(stop); });
}

SessionStore::~SessionStore() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void SessionStore::keep(const SessionState& state) {
  const std::lock_guard lock(mutex_);
  waiting_ = state;
  changed_.notify_all();
}

std::optional<Error> SessionStore::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void SessionStore::write(const std::stop_token& stop) {
  while (true) {
    std::optional<SessionState> state;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, stop, [&] { return waiting_.has_value(); });
      // A dragged slider changes the session many times a second.
      if (waiting_ && !stop.stop_requested())
        changed_.wait_for(lock, stop, kGather, [] { return false; });
      state = std::exchange(waiting_, std::nullopt);
    }
    if (state) {
      const Status written = write_file_atomically(folder_ / kSession, session_to_json(*state));
      const std::lock_guard lock(mutex_);
      problem_ = written ? std::nullopt : std::optional(written.error());
    } else if (stop.stop_requested()) {
      return;
    }
  }
}

}  // namespace alltact
