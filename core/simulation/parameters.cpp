#include "core/simulation/parameters.h"

#include "core/numerics/philox.h"
#include "core/printable.h"

#include <set>

namespace alltact {

namespace {

std::string limits_in_words(Limits l) {
  return fmt::format("a number {} {:g} and {} {:g}",
                     l.low_open ? "above" : "from",
                     l.low,
                     l.high_open ? "below" : "up to",
                     l.high);
}

bool within(double value, Limits l) {
  return (l.low_open ? value > l.low : value >= l.low) &&
         (l.high_open ? value < l.high : value <= l.high);
}

}  // namespace

Varying Varying::list(std::vector<double> values) {
  Varying varying;
  varying.values_ = std::move(values);
  return varying;
}

Varying Varying::range(double from, double to, std::string who) {
  Varying varying;
  varying.values_ = {from, to};
  varying.is_range_ = true;
  varying.who_ = std::move(who);
  return varying;
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

Parameters::Parameters(const YAML::Node& map, std::string origin, std::string path)
    : Parameters(map, std::make_shared<Shared>(), std::move(path)) {
  shared_->origin = std::move(origin);
}

Parameters::Parameters(const YAML::Node& map, std::shared_ptr<Shared> shared, std::string path)
    : shared_(std::move(shared)), here_(std::make_shared<Visited>()) {
  here_->map.reset(map);
  here_->path = std::move(path);
  shared_->maps.push_back(here_);
}

std::string Parameters::where(const std::string& key) const {
  const YAML::Node& map = here_->map;
  int line = map.IsDefined() ? map.Mark().line : -1;
  if (map.IsMap())
    for (const auto& entry : map)
      if (entry.first.IsScalar() && entry.first.Scalar() == key) line = entry.first.Mark().line;
  std::string place = shared_->origin;
  if (line >= 0) place += fmt::format(":{}", line + 1);
  const std::string name =
      here_->path.empty() || key.empty() ? here_->path + key : here_->path + "." + key;
  return name.empty() ? place : place + ": " + name;
}

void Parameters::refuse(const std::string& key, std::string what, std::string advice) {
  if (!shared_->error)
    shared_->error = std::make_unique<Error>(Error{std::move(what), where(key), std::move(advice)});
}

Status Parameters::status() const {
  if (shared_->error) return *shared_->error;
  for (const auto& visited : shared_->maps) {
    if (!visited->map.IsMap()) continue;
    std::set<std::string> seen;
    for (const auto& entry : visited->map) {
      const std::string key = entry.first.IsScalar() ? entry.first.Scalar() : "(not a word)";
      const Error error{
          fmt::format("unknown key '{}'", printable(key)),
          fmt::format("{}:{}: {}",
                      shared_->origin,
                      entry.first.Mark().line + 1,
                      visited->path.empty() ? key : visited->path + "." + key),
          visited->asked.empty() ? "" : fmt::format("one of {}", fmt::join(visited->asked, ", "))};
      if (std::find(visited->asked.begin(), visited->asked.end(), key) == visited->asked.end())
        return error;
      if (!seen.insert(key).second)
        return Error{fmt::format("the key '{}' stands here twice", printable(key)),
                     error.where,
                     "remove one of the two"};
    }
  }
  return {};
}

YAML::Node Parameters::take(const char* key) {
  auto& asked = here_->asked;
  if (std::find(asked.begin(), asked.end(), key) == asked.end()) asked.emplace_back(key);
  if (here_->map.IsMap())
    for (const auto& entry : here_->map)
      if (entry.first.IsScalar() && entry.first.Scalar() == key) return entry.second;
  return YAML::Node(YAML::NodeType::Undefined);
}

YAML::Node Parameters::take_required(const char* key) {
  const YAML::Node node = take(key);
  if (!node.IsDefined())
    refuse("", fmt::format("the key '{}' is missing", key), fmt::format("add '{}'", key));
  return node;
}

bool Parameters::has(const char* key) {
  return take(key).IsDefined();
}

double Parameters::checked(const YAML::Node& node, const std::string& key, Limits limits) {
  if (!node.IsDefined()) return limits.high;
  double value = 0;
  if (!node.IsScalar() || !YAML::convert<double>::decode(node, value) || !std::isfinite(value)) {
    refuse(key,
           fmt::format("'{}' is not a finite number",
                       printable(node.IsScalar() ? node.Scalar() : "a list or map")),
           limits_in_words(limits));
    return limits.high;
  }
  if (within(value, limits)) return value;
  if (value == 0 && limits.low == 0 && limits.low_open)
    refuse(key,
           "0 would mean that this is absent, and what is absent is not named",
           "leave it out, or give " + limits_in_words(limits));
  else
    refuse(key, fmt::format("{:g} is out of range", value), limits_in_words(limits));
  return limits.high;
}

double Parameters::number(const char* key, Limits limits) {
  return checked(take_required(key), key, limits);
}

double Parameters::number_or(const char* key, double otherwise, Limits limits) {
  const YAML::Node node = take(key);
  return node.IsDefined() ? checked(node, key, limits) : otherwise;
}

int Parameters::integer(const char* key, int low, int high) {
  const double value = number(key, {static_cast<double>(low), static_cast<double>(high)});
  if (value != std::floor(value))
    refuse(key, fmt::format("{:g} is not a whole number", value), "a whole number");
  return static_cast<int>(value);
}

int Parameters::integer_or(const char* key, int otherwise, int low, int high) {
  return has(key) ? integer(key, low, high) : otherwise;
}

Varying Parameters::checked_varying(const YAML::Node& node, const std::string& key, Limits limits) {
  if (node.IsSequence()) {
    std::vector<double> values;
    for (const auto& entry : node) values.push_back(checked(entry, key, limits));
    if (values.empty()) {
      refuse(key, "the list is empty", "one number a frame");
      values.push_back(limits.high);
    }
    return Varying::list(std::move(values));
  }
  if (node.IsMap()) {
    Parameters ends(node, shared_, here_->path.empty() ? key : here_->path + "." + key);
    const double from = ends.number("from", limits), to = ends.number("to", limits);
    if (!(from < to)) ends.refuse("from", "'from' is not below 'to'", "a range that grows");
    return Varying::range(from, to, ends.path());
  }
  return Varying(checked(node, key, limits));
}

Varying Parameters::varying(const char* key, Limits limits) {
  return checked_varying(take_required(key), key, limits);
}

Varying Parameters::varying_or(const char* key, double otherwise, Limits limits) {
  const YAML::Node node = take(key);
  return node.IsDefined() ? checked_varying(node, key, limits) : Varying(otherwise);
}

DegreeOfFreedom Parameters::degree_of_freedom(const char* name, Limits limits) {
  Parameters ends = map(name);
  const double from = ends.number("from", limits), to = ends.number("to", limits);
  if (!(from < to)) ends.refuse("from", "'from' is not below 'to'", "a range that grows");
  return {name, from, to};
}

std::string Parameters::text(const char* key) {
  const YAML::Node node = take_required(key);
  if (node.IsScalar() && !node.Scalar().empty()) return node.Scalar();
  if (node.IsDefined()) refuse(key, "this is not a text", "a word or a sentence");
  return {};
}

std::string Parameters::word(const char* key, std::initializer_list<const char*> allowed) {
  const std::string value = text(key);
  for (const char* word : allowed)
    if (value == word) return value;
  refuse(key,
         fmt::format("'{}' is not known here", printable(value)),
         fmt::format("one of {}", fmt::join(allowed.begin(), allowed.end(), ", ")));
  return *allowed.begin();
}

std::vector<double> Parameters::numbers(const char* key, int at_least, int at_most) {
  const YAML::Node node = take_required(key);
  std::vector<double> values;
  if (node.IsSequence())
    for (const auto& entry : node) values.push_back(checked(entry, key, {-1e6, 1e6}));
  const int n = static_cast<int>(values.size());
  if (node.IsDefined() && (!node.IsSequence() || n < at_least || n > at_most))
    refuse(key,
           "this is not a list of the right length",
           at_least == at_most ? fmt::format("[{} numbers]", at_least)
                               : fmt::format("[{} to {} numbers]", at_least, at_most));
  values.resize(static_cast<std::size_t>(std::clamp(n, at_least, at_most)));
  return values;
}

Parameters Parameters::map(const char* key) {
  const YAML::Node node = take_required(key);
  if (node.IsDefined() && !node.IsMap()) refuse(key, "this is not a map", "key: value, indented");
  return {node, shared_, here_->path.empty() ? key : here_->path + "." + key};
}

std::vector<Parameters> Parameters::maps(const char* key) {
  const YAML::Node node = take_required(key);
  if (node.IsDefined() && !node.IsSequence()) refuse(key, "this is not a list", "a list of maps");
  std::vector<Parameters> result;
  if (!node.IsSequence()) return result;
  for (const auto& entry : node) {
    if (!entry.IsMap()) refuse(key, "an entry of the list is not a map", "- {key: value, ...}");
    result.push_back(Parameters(entry, shared_, fmt::format("{}[{}]", key, result.size())));
  }
  return result;
}

std::vector<std::string> Parameters::keys() {
  std::vector<std::string> result;
  if (here_->map.IsMap())
    for (const auto& entry : here_->map)
      if (entry.first.IsScalar()) result.push_back(entry.first.Scalar());
  return result;
}

void Parameters::rename(std::string path) {
  here_->path = std::move(path);
}

}  // namespace alltact
