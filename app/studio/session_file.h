// The session as it is saved between two days and over a crash.
#pragma once

#include "app/studio/inspect_json.h"
#include "core/result.h"
#include "core/sources/v4l2/camera_controls.h"
#include "widgets/panels/view_options.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace alltact {

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
  bool operator==(const SessionState&) const = default;
};

inline constexpr std::size_t kMaxRecentFingers = 10;
inline constexpr const char* kSessionFormat = "alltact-session/1";

[[nodiscard]] std::string session_to_json(const SessionState& state);
/// Lenient: ignores unknown keys; values out of range become defaults. Errors: no JSON, or not a
/// session of this format.
[[nodiscard]] Result<SessionState> session_from_json(const std::string& text,
                                                     const std::string& origin);

}  // namespace alltact
