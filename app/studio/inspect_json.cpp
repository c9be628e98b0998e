#include "app/studio/inspect_json.h"

#include "app/studio/lenient_json.h"

#include <cmath>

namespace alltact {
namespace {

using Json = nlohmann::ordered_json;
using Numbers = std::vector<double>;

// In the order of the enums, which count from 1.
const std::vector<std::string> kShownAs{"3d", "height_map"};
const std::vector<std::string> kComparisons{"none", "side_by_side", "difference"};
const std::vector<std::string> kStandpoints{"tilted", "camera", "outside", "side"};
const std::vector<std::string> kComparands{"none", "paper", "setting", "frame"};

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
      numbers.size() == count && std::all_of(numbers.begin(), numbers.end(), [](double number) {
        return std::isfinite(number);
      });
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
  const bool is_complete = with.method != OtherMethod::kSetting || !with.setting.empty();
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

}  // namespace

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
                  {"frame", options.with.frame}};
  json["body"] = options.scene.body;
  json["ruler"] = options.scene.ruler;
  json["untouched"] = options.scene.untouched;
  json["camera"] = options.scene.camera;
  json["depth_top_mm"] = options.scene.top_mm;
  json["difference_top_mm"] = options.scene.difference_top_mm;
  json["depth_times"] = options.scene.exaggeration;
  if (options.a) json["a_mm"] = {options.a->along_mm, options.a->across_mm};
  if (options.b) json["b_mm"] = {options.b->along_mm, options.b->across_mm};
  return json;
}

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
  return state;
}

}  // namespace alltact
