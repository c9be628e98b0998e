#include "core/simulation/varying.h"

#include "core/numerics/philox.h"

namespace alltact {

Varying Varying::read(YamlSection& section, const std::string& key, Limits limits) {
  Varying varying;
  if (section.has_list(key)) {
    varying.values_ = section.numbers(key, limits);
    if (varying.values_.empty())
      section.refuse(key, en::say("the list is empty"), en::say("one number a frame"));
  } else if (section.has_section(key)) {
    const DegreeOfFreedom range = DegreeOfFreedom::read(section, key, limits);
    varying.values_ = {range.low, range.high};
    varying.is_range_ = true;
    varying.who_ = section.name().empty() ? key : section.name() + "." + key;
  } else {
    varying.values_ = {section.number(key, limits)};
  }
  return varying;
}

Varying Varying::read_or(YamlSection& section,
                         const std::string& key,
                         double otherwise,
                         Limits limits) {
  return section.has(key) ? read(section, key, limits) : Varying(otherwise);
}

double Varying::at(std::uint64_t seed, int frame) const {
  if (!is_range_) return values_[static_cast<std::size_t>(frame) % values_.size()];
  return values_[0] + (values_[1] - values_[0]) *
                          philox_uniform(seed, who_, static_cast<std::uint32_t>(frame), 0);
}

double Varying::least() const {
  return *std::min_element(values_.begin(), values_.end());
}
double Varying::greatest() const {
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
