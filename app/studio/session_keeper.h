// Keeps the session on disk while it changes, and notices when the program ended without goodbye.
#pragma once

#include "app/studio/session_file.h"

#include <QLockFile>
#include <condition_variable>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace alltact {

/// One thread, that of the window; files are written on another.
class SessionKeeper {
 public:
  /// `folder` is made where it is missing. A second program in the same folder keeps nothing.
  explicit SessionKeeper(std::filesystem::path folder);
  /// Writes what waits and says goodbye.
  ~SessionKeeper();
  SessionKeeper(const SessionKeeper&) = delete;
  SessionKeeper& operator=(const SessionKeeper&) = delete;

  /// What was kept last; empty for nothing.
  [[nodiscard]] const std::optional<SessionState>& last() const { return last_; }
  /// The program that kept it did not end in good order.
  [[nodiscard]] bool has_crashed() const { return has_crashed_; }
  /// Written within a second; of several only the latest.
  void keep(const SessionState& state);
  /// Why the latest could not be written.
  [[nodiscard]] std::optional<Error> problem() const;

 private:
  void write(const std::stop_token& stop);

  std::filesystem::path folder_;
  QLockFile lock_;
  bool has_crashed_ = false;
  std::optional<SessionState> last_;
  mutable std::mutex mutex_;
  std::condition_variable_any news_;
  std::optional<SessionState> waiting_;
  std::optional<Error> problem_;
  std::jthread thread_;
};

}  // namespace alltact
