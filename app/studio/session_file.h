// What was worked on, as it is kept between two days and over a crash.
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
  std::vector<std::filesystem::path> source;  ///< what opens it; empty for none
  std::string place = "live";                 ///< its name, also one of a later version
  ViewOptions view;
  InspectState inspect;
  bool is_locked = true;
  /// What was set by hand, by the camera's lasting name.
  std::map<std::string, std::vector<ControlValue>> controls;
  std::vector<std::filesystem::path> recent_fingers;  ///< latest first, at most kMostRecentFingers
  bool operator==(const SessionState&) const = default;
};

inline constexpr std::size_t kMostRecentFingers = 10;
inline constexpr const char* kSessionFormat = "alltact-session/1";

[[nodiscard]] std::string session_to_json(const SessionState& state);
/// Kind: keys it does not know are passed over, values out of range become defaults. Errors: no
/// JSON, or not a session of this format.
[[nodiscard]] Result<SessionState> session_from_json(const std::string& text,
                                                     const std::string& origin);

}  // namespace alltact
