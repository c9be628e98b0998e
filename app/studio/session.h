// The session as it is saved between two days and over a crash.
#pragma once

#include "core/base/result.h"
#include "core/base/worker.h"
#include "core/devices/camera_controls.h"
#include "widgets/inspect/inspected_frame.h"
#include "widgets/panels/image_panel.h"

#include <QLockFile>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

/// The options of Inspect, and the frame of its recording.
struct InspectState {
  InspectOptions options;
  std::size_t frame = 0;
  bool operator==(const InspectState&) const = default;
};

struct SessionState {
  std::filesystem::path finger;               ///< folder; empty for none
  std::vector<std::filesystem::path> source;  ///< paths that open it; empty for none
  std::string page = "live";                  ///< its name, also one of a later version
  ViewOptions view;
  InspectState inspect;
  bool is_locked = true;
  /// Values set by hand, by the camera's persistent name.
  std::map<std::string, std::vector<ControlValue>> controls;
  std::vector<std::filesystem::path> recent_fingers;  ///< latest first, at most kMaxRecentFingers
  /// Files and folders, likewise; neither cameras nor the program's own scenes.
  std::vector<std::filesystem::path> recent_sources;
  bool operator==(const SessionState&) const = default;
};

inline constexpr std::size_t kMaxRecentFingers = 10;
inline constexpr const char* kSessionFormat = "alltact-session/1";

[[nodiscard]] std::string session_to_json(const SessionState& state);
/// Lenient: ignores unknown keys; values out of range become defaults. Errors: no JSON, or not a
/// session of this format.
[[nodiscard]] Result<SessionState> session_from_json(const std::string& text,
                                                     const std::string& origin);

// Saves the session to disk while it changes, and detects that the program crashed.

/// For one thread, that of the window; files are written on another.
class SessionStore {
 public:
  /// Makes `folder` where it is missing. A second program in the same folder saves nothing.
  explicit SessionStore(std::filesystem::path folder);
  /// Writes a pending session and marks the end as regular.
  ~SessionStore() = default;
  SessionStore(const SessionStore&) = delete;
  SessionStore& operator=(const SessionStore&) = delete;

  /// The session saved last; nullopt for none.
  [[nodiscard]] const std::optional<SessionState>& last() const { return last_; }
  /// The program that saved it did not end regularly.
  [[nodiscard]] bool has_crashed() const { return has_crashed_; }
  /// Written within a second; of several only the latest.
  void keep(const SessionState& state) { waiting_.put(state); }
  /// Why the latest could not be written.
  [[nodiscard]] std::optional<Error> problem() const;

 private:
  void write_latest(const std::stop_token& stop);

  std::filesystem::path folder_;
  QLockFile lock_;
  bool has_crashed_ = false;
  std::optional<SessionState> last_;
  Mailbox<SessionState> waiting_;
  mutable std::mutex mutex_;  // of problem_
  std::optional<Error> problem_;
  Worker worker_;  // last: it ends first
};

}  // namespace alltact
