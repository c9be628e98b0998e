#include "core/simulation/motion.h"

#include "core/either.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <numbers>

namespace alltact {

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
      section.refuse("poses", en::say("the list is empty"), en::say("one pose a frame"));
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

Status Motion::validate(const std::vector<DegreeOfFreedom>& dofs,
                        const std::string& name,
                        double min_value,
                        double max_value) const {
  const auto dof = std::find_if(
      dofs.begin(), dofs.end(), [&](const DegreeOfFreedom& one) { return one.name == name; });
  if (dof == dofs.end()) {
    std::vector<std::string> names;
    for (const auto& one : dofs) names.push_back(one.name);
    return Error{
        en::say("the motion moves '{}', but no effect of the scene does", name),
        where_,
        names.empty() ? en::say("name `bend` or `sway` among the effects") : one_of(names, name)};
  }
  for (const double value : {min_value, max_value})
    if (value < dof->low || value > dof->high)
      return Error{en::say("{} = {:g} is outside the effect's range", name, value),
                   where_,
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
    return Error{en::say("the motion has nothing to move"),
                 where_,
                 en::say("name `bend` or `sway` among the effects, or leave the motion out")};
  return {};
}

}  // namespace alltact
