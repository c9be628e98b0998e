#include "core/simulation/varying.h"

#include "core/numerics/philox.h"
#include "core/simulation/scene_time.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace alltact {

Varying Varying::read(YamlSection& section, const std::string& key, Limits limits) {
  Varying varying;
  if (section.has_sections(key)) {
    varying.read_key_frames(section, key, limits);
  } else if (section.has_list(key)) {
    varying.values_ = section.numbers(key, limits);
    if (varying.values_.empty())
      section.refuse(key, en::say("the list is empty"), en::say("one number a frame"));
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
      given.refuse("at",
                   en::say("the key frame before it stands there too"),
                   en::say("a later time, or leave one of the two out"));
    if (!key_frames_.empty() && at < key_frames_.back().at)
      given.refuse("at",
                   en::say("the key frame before it is a later one"),
                   en::say("key frames in the order of their times"));
    key_frames_.push_back({at, is_smooth});
  }
}

double Varying::between_key_frames(double frame) const {
  const auto next = std::upper_bound(
      key_frames_.begin(), key_frames_.end(), frame, [](double f, const KeyFrame& key_frame) {
        return f < key_frame.at;
      });
  const auto i = static_cast<std::size_t>(next - key_frames_.begin());
  if (i == 0) return values_.front();
  if (i == key_frames_.size()) return values_.back();
  const double t = (frame - key_frames_[i - 1].at) / (key_frames_[i].at - key_frames_[i - 1].at);
  const double share = key_frames_[i].is_smooth ? 0.5 - 0.5 * std::cos(std::numbers::pi * t) : t;
  return values_[i - 1] + (values_[i] - values_[i - 1]) * share;
}

Varying Varying::read_or(YamlSection& section,
                         const std::string& key,
                         double otherwise,
                         Limits limits) {
  return section.has(key) ? read(section, key, limits) : Varying(otherwise);
}

double Varying::at(std::uint64_t seed, int frame) const {
  if (kind_ == Kind::kList) return values_[static_cast<std::size_t>(frame) % values_.size()];
  if (kind_ == Kind::kKeyFrames) return between_key_frames(frame % frames_);
  return values_[0] + (values_[1] - values_[0]) *
                          philox_uniform(seed, stream_, static_cast<std::uint32_t>(frame), 0);
}

double Varying::min_value() const {
  return *std::min_element(values_.begin(), values_.end());
}
double Varying::max_value() const {
  return *std::max_element(values_.begin(), values_.end());
}

DegreeOfFreedom DegreeOfFreedom::read(YamlSection& section,
                                      const std::string& name,
                                      Limits limits) {
  YamlSection ends = section.section(name);
  const double from = ends.number("from", limits), to = ends.number("to", limits);
  if (!(from < to))
    ends.refuse("from", en::say("'from' is not below 'to'"), en::say("a range that grows"));
  return {name, from, to};
}

}  // namespace alltact
