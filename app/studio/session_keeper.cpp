#include "app/studio/session_keeper.h"

#include "core/io/atomic_file.h"

#include <chrono>

namespace alltact {
namespace {

constexpr const char* kSession = "session.json";
constexpr const char* kLock = "running.lock";
constexpr std::size_t kLargestSession = std::size_t{1} << 20;
constexpr std::chrono::milliseconds kGather{300};

}  // namespace

SessionKeeper::SessionKeeper(std::filesystem::path folder)
    : folder_(std::move(folder)), lock_(QString::fromStdString((folder_ / kLock).string())) {
  if (const Status made = make_folder(folder_); !made) problem_ = made.error();
  std::error_code ignored;
  const bool was_left = std::filesystem::exists(folder_ / kLock, ignored);
  lock_.setStaleLockTime(0);  // only a program that runs holds it
  const bool is_ours = lock_.tryLock(0);
  has_crashed_ = was_left && is_ours;
  if (const auto text = read_file(folder_ / kSession, kLargestSession)) {
    auto state = session_from_json(*text, (folder_ / kSession).string());
    if (state) last_ = std::move(*state);
  }
  if (!last_) has_crashed_ = false;
  if (is_ours) thread_ = std::jthread([this](const std::stop_token& stop) { write(stop); });
}

SessionKeeper::~SessionKeeper() {
  thread_.request_stop();
  if (thread_.joinable()) thread_.join();
}

void SessionKeeper::keep(const SessionState& state) {
  const std::lock_guard lock(mutex_);
  waiting_ = state;
  news_.notify_all();
}

std::optional<Error> SessionKeeper::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void SessionKeeper::write(const std::stop_token& stop) {
  while (true) {
    std::optional<SessionState> state;
    {
      std::unique_lock lock(mutex_);
      news_.wait(lock, stop, [&] { return waiting_.has_value(); });
      // A slider that is drawn changes the session many times a second.
      if (waiting_ && !stop.stop_requested())
        news_.wait_for(lock, stop, kGather, [] { return false; });
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
