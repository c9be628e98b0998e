// Saves the session to disk while it changes, and detects that the program crashed.
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

/// For one thread, that of the window; files are written on another.
class SessionStore {
 public:
  /// Makes `folder` where it is missing. A second program in the same folder saves nothing.
  explicit SessionStore(std::filesystem::path folder);
  /// Writes a pending session and marks the end as regular.
  ~SessionStore();
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  /// The session saved last; nullopt for none.
  [[nodiscard]] const std::optional<SessionState>& last() const { return last_; }
  /// The program that saved it did not end regularly.
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
  std::condition_variable_any changed_;
  std::optional<SessionState> waiting_;
  std::optional<Error> problem_;
  std::jthread thread_;
};

}  // namespace alltact
