#include "core/simulation/scene_time.h"

#include "core/base/message.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string_view>

namespace alltact {
namespace {

constexpr double kLatest = 1e9;      // frames or seconds
constexpr double kSameFrame = 1e-6;  // rounding tolerance of a frame's time

// The first frame at or after a point in time.
int frame_from(double point, const SceneTime& time) {
  return static_cast<int>(std::ceil(std::min(point, double(time.frames)) - kSameFrame));
}

}  // namespace

SceneTime SceneTime::of(const YamlSection& part) {
  YamlSection scene = part.top();
  return {scene.integer_or("frames", 1, 1, 1000000),
          scene.number_or("frames_per_s", 30, {0.1, 10000})};
}

double SceneTime::point(YamlSection& section, const std::string& key) const {
  const std::string text = section.text(key);
  std::string_view number = text;
  const bool in_seconds = number.ends_with('s');
  if (in_seconds) number.remove_suffix(1);
  while (in_seconds && number.ends_with(' ')) number.remove_suffix(1);
  double value = -1;
  const auto [end, status] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (status != std::errc{} || end != number.data() + number.size() ||
      !(value >= 0 && value <= kLatest))
    section.refuse(key, en::say("must be a point in time, not '{}'", printable(text)),
                   en::say("a frame such as 60, or seconds such as 2 s"), ErrorKind::kWrongValue);
  return in_seconds ? value * frames_per_s : value;
}

Presence Presence::read(YamlSection& effect, const SceneTime& time) {
  Presence presence{0, time.frames};
  if (effect.has("from")) {
    presence.first = frame_from(time.point(effect, "from"), time);
    if (presence.first >= time.frames)
      effect.refuse("from", en::say("the scene ends before that"),
                    en::say("one of its frames, 0 to {}", time.frames - 1));
  }
  if (effect.has("until")) {
    presence.end = frame_from(time.point(effect, "until"), time);
    if (presence.end <= presence.first)
      effect.refuse(
          "until", en::say("it would never be active, for it begins with frame {}", presence.first),
          en::say("a later frame, or leave the effect out"));
  }
  return presence;
}

Varying Varying::read(YamlSection& section, const std::string& key, Limits limits) {
  Varying varying;
  if (section.has_sections(key)) {
    varying.read_key_frames(section, key, limits);
  } else if (section.has_list(key)) {
    varying.values_ = section.numbers(key, limits);
    if (varying.values_.empty())
      section.refuse(key, en::say("the list is empty"), en::say("one number per frame"));
  } else if (section.has_section(key)) {
    const DegreeOfFreedom range = DegreeOfFreedom::read(section, key, limits);
    varying.values_ = {range.low, range.high};
    varying.kind_ = Kind::kRange;
    varying.stream_ = section.name().empty() ? key : section.name() + "." + key;
  } else {
    varying.values_ = {section.number(key, limits)};
  }
  return varying;
}

void Varying::read_key_frames(YamlSection& section, const std::string& key, Limits limits) {
  kind_ = Kind::kKeyFrames;
  values_.clear();
  const SceneTime time = SceneTime::of(section);
  frames_ = time.frames;
  for (YamlSection& given : section.sections(key)) {
    const double at = time.point(given, "at");
    values_.push_back(given.number("is", limits));
    const bool is_smooth = given.has("by") && given.choice("by", {"straight", "smooth"}) == 1;
    if (!key_frames_.empty() && at == key_frames_.back().at)
      given.refuse("at", en::say("the key frame before it has the same time"),
                   en::say("a later time, or leave one of the two out"));
    if (!key_frames_.empty() && at < key_frames_.back().at)
      given.refuse("at", en::say("the key frame before it has a later time"),
                   en::say("key frames in order of time"));
    key_frames_.push_back({at, is_smooth});
  }
}

double Varying::between_key_frames(double frame) const {
  const auto next =
      std::upper_bound(key_frames_.begin(), key_frames_.end(), frame,
                       [](double f, const KeyFrame& key_frame) { return f < key_frame.at; });
  const auto i = static_cast<std::size_t>(next - key_frames_.begin());
  if (i == 0) return values_.front();
  if (i == key_frames_.size()) return values_.back();
  const double t = (frame - key_frames_[i - 1].at) / (key_frames_[i].at - key_frames_[i - 1].at);
  const double share = key_frames_[i].is_smooth ? 0.5 - 0.5 * std::cos(std::numbers::pi * t) : t;
  return values_[i - 1] + (values_[i] - values_[i - 1]) * share;
}

Varying Varying::read_or(YamlSection& section, const std::string& key, double otherwise,
                         Limits limits) {
  return section.has(key) ? read(section, key, limits) : Varying(otherwise);
}

double Varying::at(std::uint64_t seed, int frame) const {
  if (kind_ == Kind::kList) return values_[static_cast<std::size_t>(frame) % values_.size()];
  if (kind_ == Kind::kKeyFrames) return between_key_frames(frame % frames_);
  return values_[0] + (values_[1] - values_[0]) *
                          philox_uniform(seed, stream_, static_cast<std::uint32_t>(frame), 0);
}

double Varying::min_value() const { return *std::min_element(values_.begin(), values_.end()); }
double Varying::max_value() const { return *std::max_element(values_.begin(), values_.end()); }

DegreeOfFreedom DegreeOfFreedom::read(YamlSection& section, const std::string& name,
                                      Limits limits) {
  YamlSection ends = section.section(name);
  const double from = ends.number("from", limits), to = ends.number("to", limits);
  if (!(from < to))
    ends.refuse("from", en::say("'from' is not below 'to'"), en::say("an increasing range"));
  return {name, from, to};
}

namespace {

constexpr Limits kPoseLimits{-1000, 1000};

// Radical inverse of k in base b, in [0, 1).
double halton(int k, int base) {
  double value = 0, digit = 1;
  for (; k > 0; k /= base) {
    digit /= base;
    value += digit * (k % base);
  }
  return value;
}

// A separate base for each degree of freedom, chosen by name and not by order in the scene.
int base_of(const std::string& name) {
  if (name == "q1_mm") return 2;
  if (name == "q2_mm") return 3;
  if (name == "sway_mm") return 5;
  constexpr std::array kOthers{7, 11, 13, 17, 19};
  return kOthers[fnv1a(name) % kOthers.size()];
}

}  // namespace

Motion Motion::read(YamlSection& section) {
  Motion motion;
  motion.where_ = section.where("");
  const std::vector<std::string_view> kinds{"hold", "path", "poses", "random", "wander"};
  const std::string_view kind = kinds[section.choice("kind", kinds)];
  const auto read_pose = [](YamlSection given) {
    Pose pose;
    for (const std::string& key : given.keys()) pose[key] = given.number(key, kPoseLimits);
    return pose;
  };
  if (kind == "hold" && section.has("pose")) motion.poses_ = {read_pose(section.section("pose"))};
  if (kind == "path") {
    motion.kind_ = Kind::kPath;
    for (const std::string& key : section.keys())
      if (key != "kind") motion.path_.emplace(key, Varying::read(section, key, kPoseLimits));
  }
  if (kind == "poses") {
    motion.poses_.clear();
    for (const YamlSection& given : section.sections("poses"))
      motion.poses_.push_back(read_pose(given));
    if (motion.poses_.empty())
      section.refuse("poses", en::say("the list is empty"), en::say("one pose per frame"));
  }
  if (kind == "random") motion.kind_ = Kind::kRandom;
  if (kind == "wander") {
    motion.kind_ = Kind::kWander;
    motion.frames_per_move_ = section.number("frames_per_move", {1, 10000});
  }
  return motion;
}

double Motion::value(const DegreeOfFreedom& dof, std::uint64_t seed, int frame) const {
  const std::string stream = "motion." + dof.name;
  const auto in_range = [&](double unit) { return dof.low + (dof.high - dof.low) * unit; };
  switch (kind_) {
    case Kind::kRandom:
      return in_range(philox_uniform(seed, stream, static_cast<std::uint32_t>(frame), 0));
    case Kind::kWander: {
      const double shift = philox_uniform(seed, stream, 0, 0);
      const auto waypoint = [&](int k) {
        if (k == 0) return std::clamp(0.0, dof.low, dof.high);
        const double unit = halton(k + 1, base_of(dof.name)) + shift;
        return in_range(unit - std::floor(unit));
      };
      const double move = frame / frames_per_move_;
      const int k = static_cast<int>(move);
      const double ease = 0.5 - 0.5 * std::cos(std::numbers::pi * (move - k));
      return waypoint(k) + (waypoint(k + 1) - waypoint(k)) * ease;
    }
    case Kind::kPath: {
      const auto found = path_.find(dof.name);
      return found == path_.end() ? 0.0 : found->second.at(seed, frame);
    }
    case Kind::kPoses:
      break;
  }
  const Pose& pose = poses_[static_cast<std::size_t>(frame) % poses_.size()];
  const auto found = pose.find(dof.name);
  return found == pose.end() ? 0.0 : found->second;
}

Status Motion::validate(const std::vector<DegreeOfFreedom>& dofs, const std::string& name,
                        double min_value, double max_value) const {
  const auto dof = std::find_if(dofs.begin(), dofs.end(),
                                [&](const DegreeOfFreedom& one) { return one.name == name; });
  if (dof == dofs.end()) {
    std::vector<std::string> names;
    for (const auto& one : dofs) names.push_back(one.name);
    return Error{
        en::say("the motion moves '{}', but the scene has no such effect", name), where_,
        names.empty() ? en::say("add `bend` or `sway` to the effects") : one_of(names, name)};
  }
  for (const double value : {min_value, max_value})
    if (value < dof->low || value > dof->high)
      return Error{en::say("{} = {:g} is outside the effect's range", name, value), where_,
                   en::say("{:g} to {:g}", dof->low, dof->high)};
  return {};
}

Status Motion::validate(const std::vector<DegreeOfFreedom>& dofs) const {
  for (const Pose& pose : poses_)
    for (const auto& [name, value] : pose)
      if (const Status status = validate(dofs, name, value, value); !status) return status;
  for (const auto& [name, values] : path_)
    if (const Status status = validate(dofs, name, values.min_value(), values.max_value()); !status)
      return status;
  const bool moves_all = kind_ == Kind::kRandom || kind_ == Kind::kWander;
  if (moves_all && dofs.empty())
    return Error{en::say("the motion has nothing to move"), where_,
                 en::say("add `bend` or `sway` to the effects, or leave the motion out")};
  return {};
}

}  // namespace alltact
