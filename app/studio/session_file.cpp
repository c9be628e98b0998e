#include "app/studio/session_file.h"

#include "app/studio/lenient_json.h"

#include <algorithm>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::filesystem::path> paths_of(const Json& map, const char* key) {
  const auto texts = value_or(map, key, std::vector<std::string>{});
  return {texts.begin(), texts.end()};
}

std::vector<std::string> texts_of(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> texts;
  for (const auto& path : paths) texts.push_back(path.string());
  return texts;
}

ViewOptions view_of(const Json& json) {
  ViewOptions view;
  if (!json.is_object()) return view;
  view.edges = value_or(json, "edges", view.edges);
  view.markers = value_or(json, "markers", view.markers);
  view.direction = value_or(json, "direction", view.direction);
  view.depth = value_or(json, "depth", view.depth);
  view.faults = value_or(json, "faults", view.faults);
  const double top_mm = value_or(json, "depth_top_mm", view.depth_top_mm);
  if (top_mm >= 0.1 && top_mm <= 10) view.depth_top_mm = top_mm;
  return view;
}

std::vector<ControlValue> controls_of(const Json& json) {
  std::vector<ControlValue> controls;
  if (!json.is_array()) return controls;
  for (const Json& entry : json)
    if (entry.is_object() && entry.contains("id") && entry.contains("value"))
      controls.push_back({value_or(entry, "id", std::uint32_t{0}),
                          value_or(entry, "name", std::string()),
                          value_or(entry, "value", std::int64_t{0})});
  return controls;
}

}  // namespace

std::string session_to_json(const SessionState& state) {
  Json json;
  json["format"] = kSessionFormat;
  json["finger"] = state.finger.string();
  json["source"] = texts_of(state.source);
  json["place"] = state.page;
  json["view"] = {{"edges", state.view.edges},
                  {"markers", state.view.markers},
                  {"direction", state.view.direction},
                  {"depth", state.view.depth},
                  {"faults", state.view.faults},
                  {"depth_top_mm", state.view.depth_top_mm}};
  json["inspect"] = inspect_to_json(state.inspect);
  json["locked"] = state.is_locked;
  json["controls"] = Json::object();
  for (const auto& [camera, controls] : state.controls)
    for (const ControlValue& control : controls)
      json["controls"][camera].push_back(
          {{"id", control.id}, {"name", control.name}, {"value", control.value}});
  json["recent_fingers"] = texts_of(state.recent_fingers);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<SessionState> session_from_json(const std::string& text, const std::string& origin) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || value_or(json, "format", std::string()) != kSessionFormat)
    return Error{
        en::say("this is not a session of this program"), origin, en::say("beginning a new one")};
  SessionState state;
  state.finger = value_or(json, "finger", std::string());
  state.source = paths_of(json, "source");
  state.page = value_or(json, "place", state.page);
  state.view = view_of(value_or(json, "view", Json::object()));
  state.inspect = inspect_from_json(value_or(json, "inspect", Json::object()));
  state.is_locked = value_or(json, "locked", true);
  const Json controls = value_or(json, "controls", Json::object());
  if (controls.is_object())
    for (const auto& [camera, values] : controls.items())
      state.controls[camera] = controls_of(values);
  state.recent_fingers = paths_of(json, "recent_fingers");
  if (state.recent_fingers.size() > kMaxRecentFingers)
    state.recent_fingers.resize(kMaxRecentFingers);
  return state;
}

}  // namespace alltact
