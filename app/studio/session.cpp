#include "app/studio/session.h"

#include "core/base/atomic_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <nlohmann/json.hpp>

namespace alltact {
namespace {

/// The value of a key of `map`, which may be no map at all.
template <class T>
T value_or(const nlohmann::ordered_json& map, const char* key, T otherwise) {
  const auto found = map.find(key);
  if (found == map.end()) return otherwise;
  try {
    return found->template get<T>();
  } catch (const nlohmann::ordered_json::exception&) {
    return otherwise;
  }
}

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
  view.focus = value_or(json, "focus", view.focus);
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

using Numbers = std::vector<double>;

// In the order of the enums, which count from 1.
const std::vector<std::string> kShownAs{"3d", "height_map"};
const std::vector<std::string> kComparisons{"none", "side_by_side", "difference"};
const std::vector<std::string> kStandpoints{"tilted", "camera", "outside", "side"};
const std::vector<std::string> kComparands{"none",      "paper",  "setting", "frame",
                                           "recording", "finger", "body"};

template <class E>
std::string word_of(const std::vector<std::string>& words, E value) {
  return words.at(static_cast<std::size_t>(value) - 1);
}

template <class E>
E enum_of(const Json& json, const char* key, const std::vector<std::string>& words, E otherwise) {
  const auto word = std::find(words.begin(), words.end(), value_or(json, key, std::string()));
  return word == words.end() ? otherwise : static_cast<E>(word - words.begin() + 1);
}

/// Exactly so many, all finite; else nullopt.
std::optional<Numbers> numbers_of(const Json& json, const char* key, std::size_t count) {
  const auto numbers = value_or(json, key, Numbers());
  const bool is_complete =
      numbers.size() == count && std::all_of(numbers.begin(), numbers.end(),
                                             [](double number) { return std::isfinite(number); });
  return is_complete ? std::optional(numbers) : std::nullopt;
}

std::optional<FacePosition> position_of(const Json& json, const char* key) {
  const auto at = numbers_of(json, key, 2);
  return at ? std::optional(FacePosition{(*at)[0], (*at)[1]}) : std::nullopt;
}

ComparisonSpec comparand_of(const Json& json) {
  ComparisonSpec with{OtherMethod::kPaper};
  if (!json.is_object()) return with;
  with.method = enum_of(json, "method", kComparands, with.method);
  if (with.method == OtherMethod::kNone) with.method = OtherMethod::kPaper;
  with.setting = value_or(json, "setting", std::string());
  with.value = value_or(json, "value", std::string());
  with.frame = value_or(json, "frame", std::size_t{0});
  with.file = value_or(json, "file", std::string());
  with.finger = value_or(json, "finger", std::string());
  const bool is_complete = (with.method != OtherMethod::kSetting || !with.setting.empty()) &&
                           (!needs_file(with.method) || !with.file.empty()) &&
                           (with.method != OtherMethod::kFinger || !with.finger.empty());
  return is_complete ? with : ComparisonSpec{OtherMethod::kPaper};
}

std::optional<ViewPose> look_of(const Json& json) {
  const auto n = numbers_of(json, "look", 9);
  if (!n) return std::nullopt;
  const ViewPose look{
      {(*n)[0], (*n)[1], (*n)[2]}, {(*n)[3], (*n)[4], (*n)[5]}, {(*n)[6], (*n)[7], (*n)[8]}};
  // A view along "up", or with the target at the eye, is impossible.
  const bool is_possible = (look.at - look.eye).cross(look.up).norm() > 1e-6;
  return is_possible ? std::optional(look) : std::nullopt;
}

SceneOptions scene_of(const Json& json) {
  SceneOptions scene;
  scene.body = value_or(json, "body", scene.body);
  scene.ruler = value_or(json, "ruler", scene.ruler);
  scene.untouched = value_or(json, "untouched", scene.untouched);
  scene.camera = value_or(json, "camera", scene.camera);
  const double top_mm = value_or(json, "depth_top_mm", scene.top_mm);
  if (top_mm >= 0.05 && top_mm <= 10) scene.top_mm = top_mm;
  const double difference_mm = value_or(json, "difference_top_mm", scene.difference_top_mm);
  if (difference_mm >= 0.01 && difference_mm <= 2) scene.difference_top_mm = difference_mm;
  const double exaggeration = value_or(json, "depth_times", scene.exaggeration);
  if (exaggeration >= 1 && exaggeration <= 50) scene.exaggeration = exaggeration;
  return scene;
}

Json inspect_to_json(const InspectState& state) {
  const InspectOptions& options = state.options;
  Json json;
  json["recording"] = options.recording.string();
  json["frame"] = state.frame;
  if (options.second)
    json["second"] = {{"finger", options.second->finger.string()},
                      {"recording", options.second->recording.string()}};
  json["shown_as"] = word_of(kShownAs, options.shown_as);
  json["comparison"] = word_of(kComparisons, options.comparison);
  json["standpoint"] = word_of(kStandpoints, options.viewpoint);
  if (const auto& look = options.view_pose) {
    Numbers numbers;
    for (const Eigen::Vector3d& part : {look->eye, look->at, look->up})
      numbers.insert(numbers.end(), part.begin(), part.end());
    json["look"] = numbers;
  }
  json["with"] = {{"method", word_of(kComparands, options.with.method)},
                  {"setting", options.with.setting},
                  {"value", options.with.value},
                  {"frame", options.with.frame},
                  {"file", options.with.file.string()},
                  {"finger", options.with.finger.string()}};
  json["body"] = options.scene.body;
  json["ruler"] = options.scene.ruler;
  json["untouched"] = options.scene.untouched;
  json["camera"] = options.scene.camera;
  json["depth_top_mm"] = options.scene.top_mm;
  json["difference_top_mm"] = options.scene.difference_top_mm;
  json["depth_times"] = options.scene.exaggeration;
  if (options.a) json["a_mm"] = {options.a->along_mm, options.a->across_mm};
  if (options.b) json["b_mm"] = {options.b->along_mm, options.b->across_mm};
  json["form_degree"] = options.filter.form_degree;
  if (options.filter.lambda_c_mm) json["lambda_c_mm"] = *options.filter.lambda_c_mm;
  if (!options.recipe.readings.empty()) json["recipe"] = options.recipe.to_yaml();
  return json;
}

/// Lenient: ignores unknown entries; impossible values become defaults.
InspectState inspect_from_json(const Json& json) {
  InspectState state;
  if (!json.is_object()) return state;
  InspectOptions& options = state.options;
  options.recording = value_or(json, "recording", std::string());
  state.frame = value_or(json, "frame", std::size_t{0});
  const Json second = value_or(json, "second", Json());
  if (second.is_object() && !options.recording.empty()) {
    const SecondFinger finger{value_or(second, "finger", std::string()),
                              value_or(second, "recording", std::string())};
    if (!finger.finger.empty() && !finger.recording.empty()) options.second = finger;
  }
  options.shown_as = enum_of(json, "shown_as", kShownAs, options.shown_as);
  options.comparison = enum_of(json, "comparison", kComparisons, options.comparison);
  options.viewpoint = enum_of(json, "standpoint", kStandpoints, options.viewpoint);
  options.view_pose = look_of(json);
  options.scene = scene_of(json);
  options.with = comparand_of(value_or(json, "with", Json()));
  options.a = position_of(json, "a_mm");
  options.b = position_of(json, "b_mm");
  const int degree = value_or(json, "form_degree", options.filter.form_degree);
  if (degree >= 1 && degree <= kMaxFormDegree) options.filter.form_degree = degree;
  const double lambda_c_mm = value_or(json, "lambda_c_mm", 0.0);
  if (lambda_c_mm > 0 && lambda_c_mm <= 100) options.filter.lambda_c_mm = lambda_c_mm;
  const std::string recipe = value_or(json, "recipe", std::string());
  if (auto read = InspectionRecipe::parse(recipe, kSessionFormat); read && !recipe.empty())
    options.recipe = std::move(*read);
  return state;
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
                  {"focus", state.view.focus},
                  {"depth_top_mm", state.view.depth_top_mm}};
  json["inspect"] = inspect_to_json(state.inspect);
  json["locked"] = state.is_locked;
  json["controls"] = Json::object();
  for (const auto& [camera, controls] : state.controls)
    for (const ControlValue& control : controls)
      json["controls"][camera].push_back(
          {{"id", control.id}, {"name", control.name}, {"value", control.value}});
  json["recent_fingers"] = texts_of(state.recent_fingers);
  json["recent_sources"] = texts_of(state.recent_sources);
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Result<SessionState> session_from_json(const std::string& text, const std::string& origin) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || value_or(json, "format", std::string()) != kSessionFormat)
    return Error{en::say("this is not a session of this program"), origin,
                 en::say("starting a new one")};
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
  state.recent_sources = paths_of(json, "recent_sources");
  for (auto* recent : {&state.recent_fingers, &state.recent_sources})
    if (recent->size() > kMaxRecentFingers) recent->resize(kMaxRecentFingers);
  return state;
}

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
  if (has_lock) worker_ = Worker([this](const std::stop_token& stop) { write_latest(stop); });
}

std::optional<Error> SessionStore::problem() const {
  const std::lock_guard lock(mutex_);
  return problem_;
}

void SessionStore::write_latest(const std::stop_token& stop) {
  while (auto state = waiting_.wait(stop)) {
    // A dragged slider changes the session many times a second.
    static_cast<void>(is_stopped_within(stop, kGather));
    if (auto newer = waiting_.take()) state = std::move(newer);
    const Status written =
        guarded([&] { return write_file_atomically(folder_ / kSession, session_to_json(*state)); });
    const std::lock_guard lock(mutex_);
    problem_ = written ? std::nullopt : std::optional(written.error());
  }
}

}  // namespace alltact
