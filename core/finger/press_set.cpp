#include "core/finger/press_set.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCalibratedFrom = "calibration_inputs.yaml";
constexpr Limits kRadiusMm{0, kLargestBallMm, true}, kLengthMm{0, kDeepestMm, true};
constexpr Limits kPositionMm{-10000, 10000};  // position of a ball, from the camera

/// Reads the presses that `key` names, with their values from another key.
template <class T>
void read_pairs(YamlSection& top, const char* key, const char* values_key,
                const std::function<std::vector<T>()>& read_values,
                const std::function<void(const std::string& press, const T& value)>& take) {
  if (!top.has(key)) return;
  const auto names = top.texts(key);
  const std::vector<T> values = read_values();
  if (values.size() != names.size())
    top.refuse(values_key, en::say("has {} entries for {} presses", values.size(), names.size()),
               en::say("one for each press, \"\" for none"));
  for (std::size_t i = 0; i < names.size(); ++i) take(names[i], values[i]);
}

using Rows = std::vector<double>;

GivenDepth depth_of(YamlSection& top, const Rows& row) {
  if (row.size() != 2)
    top.refuse("depths_mm", en::say("must hold two numbers for each press"),
               en::say("a depth and its standard deviation in mm"));
  return {row[0], row[1]};
}

Eigen::Vector3d centre_of(YamlSection& top, const Rows& row) {
  if (row.size() != 3 || !(row[2] > 0))
    top.refuse("balls_mm", en::say("is not a ball centre in front of the camera"),
               en::say("x, y, z in mm"));
  return {row[0], row[1], row[2]};
}

/// Adds the presses that have this value, and the values; both as YAML.
void add_pairs(const PressSet& presses, const char* key, const char* values_key,
               const std::function<std::optional<std::string>(const PressNote&)>& value,
               YamlBlock& block) {
  std::vector<std::string> names, values;
  for (const auto& [name, note] : presses.notes) {
    auto text = value(note);
    if (!text) continue;
    names.push_back(yaml_text(name));
    values.push_back(std::move(*text));
  }
  if (names.empty()) return;
  block.add(key, yaml_list(names));
  block.add(values_key, yaml_list(values));
}

std::optional<std::string> number_text(const std::optional<double>& value) {
  return value ? std::optional(yaml_number(*value)) : std::nullopt;
}

void check_format(YamlSection& top) {
  if (const std::string format = top.text("format"); format != PressSet::kFormat)
    top.refuse("format", en::say("'{}' cannot be read by this version", printable(format)), "");
}

}  // namespace

const PressNote& PressSet::of(const std::string& press) const {
  static const PressNote nothing;
  const auto found = notes.find(press);
  return found == notes.end() ? nothing : found->second;
}

void PressSet::say(const std::string& press, PressNote note) {
  if (note == PressNote())
    notes.erase(press);
  else
    notes[press] = std::move(note);
}

double PressSet::radius_of(const std::string& press) const {
  return of(press).ball_radius_mm.value_or(ball_radius_mm);
}

bool PressSet::has_other_balls() const {
  return std::any_of(notes.begin(), notes.end(),
                     [](const auto& entry) { return entry.second.ball_radius_mm.has_value(); });
}

PressSet PressSet::only(const std::set<std::string>& presses) const {
  PressSet presses_read = *this;
  std::erase_if(presses_read.notes,
                [&](const auto& entry) { return !presses.contains(entry.first); });
  return presses_read;
}

PressSet read_press_set(YamlSection& top, bool requires_radius) {
  PressSet presses_read;
  if (requires_radius || top.has("ball_radius_mm"))
    presses_read.ball_radius_mm = top.number("ball_radius_mm", kRadiusMm);
  if (top.has("operator")) presses_read.operator_name = top.text("operator");
  auto& notes = presses_read.notes;
  read_pairs<double>(
      top, "other_balls", "other_balls_mm",
      [&] { return top.numbers("other_balls_mm", kRadiusMm); },
      [&](const auto& press, double mm) { notes[press].ball_radius_mm = mm; });
  read_pairs<Rows>(
      top, "depths", "depths_mm", [&] { return top.rows("depths_mm", kLengthMm); },
      [&](const auto& press, const Rows& row) { notes[press].depth = depth_of(top, row); });
  read_pairs<double>(
      top, "steps", "steps_mm", [&] { return top.numbers("steps_mm", kLengthMm); },
      [&](const auto& press, double mm) { notes[press].step_mm = mm; });
  read_pairs<Rows>(
      top, "balls", "balls_mm", [&] { return top.rows("balls_mm", kPositionMm); },
      [&](const auto& press, const Rows& row) { notes[press].ball_mm = centre_of(top, row); });
  read_pairs<std::string>(
      top, "excluded", "excluded_because", [&] { return top.texts("excluded_because"); },
      [&](const auto& press, const std::string& because) { notes[press].excluded = because; });
  return presses_read;
}

void add_all_presses(const PressSet& presses, YamlBlock& block) {
  if (!presses.operator_name.empty()) block.add("operator", yaml_text(presses.operator_name));
  if (presses.ball_radius_mm > 0) block.add("ball_radius_mm", yaml_number(presses.ball_radius_mm));
}

void add_single_presses(const PressSet& presses, YamlBlock& block) {
  const auto add = [&](const char* key, const char* values_key, auto value) {
    add_pairs(presses, key, values_key, value, block);
  };
  using Text = std::optional<std::string>;
  add("other_balls", "other_balls_mm",
      [](const PressNote& note) { return number_text(note.ball_radius_mm); });
  add("depths", "depths_mm", [](const PressNote& note) {
    return note.depth ? Text(yaml_numbers({note.depth->mm, note.depth->sd_mm})) : Text();
  });
  add("steps", "steps_mm", [](const PressNote& note) { return number_text(note.step_mm); });
  add("balls", "balls_mm", [](const PressNote& note) {
    const auto& at = note.ball_mm;
    return at ? Text(yaml_numbers({at->x(), at->y(), at->z()})) : Text();
  });
  add("excluded", "excluded_because", [](const PressNote& note) {
    return note.excluded ? Text(yaml_text(*note.excluded)) : Text();
  });
}

fs::path PressSet::file_in(const fs::path& finger_folder) {
  std::error_code failed;
  const fs::path own = finger_folder / kFileName;
  return fs::exists(own, failed) ? own : finger_folder / kCalibratedFrom;
}

Result<PressSet> PressSet::load(const fs::path& finger_folder) {
  const fs::path file = file_in(finger_folder);
  std::error_code failed;
  if (!fs::exists(file, failed)) return PressSet();
  const auto content = read_file(file, YamlFile::kMaxBytes);
  if (!content) return content.error();
  if (file.filename() == kFileName) return parse(*content, file);
  YamlFile inputs(file);
  PressSet presses;
  const Status read =
      inputs.read(*content, [&](YamlSection& top) { presses = read_press_set(top); });
  if (!read) return read.error();
  return presses;
}

Result<PressSet> PressSet::parse(const std::string& yaml, const fs::path& origin) {
  YamlFile file(origin);
  PressSet presses;
  const Status read = file.read(yaml, [&](YamlSection& top) {
    check_format(top);
    presses = read_press_set(top);
  });
  if (!read) return read.error();
  return presses;
}

std::string PressSet::to_yaml() const {
  YamlBlock block("");
  block.add("format", kFormat);
  add_all_presses(*this, block);
  add_single_presses(*this, block);
  return block.on_many_lines();
}

Status PressSet::save(const fs::path& finger_folder) const {
  return write_file_atomically(finger_folder / kFileName, to_yaml());
}

}  // namespace alltact
