#include "core/finger/press_set.h"

#include "core/base/atomic_file.h"
#include "core/base/fields.h"
#include "core/base/message.h"

#include <algorithm>
#include <array>
#include <vector>

namespace alltact {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCalibratedFrom = "calibration_inputs.yaml";
constexpr Limits kRadiusMm{0, kLargestBallMm, true}, kLengthMm{0, kDeepestMm, true};
constexpr Limits kPositionMm{-10000, 10000};  // position of a ball, from the camera

/// Presses that have a value, and the values: two lists. `describe_values` reads or writes a vector
/// of them.
template <class T, class Describe>
void describe_pairs(Fields& fields, std::map<std::string, PressNote>& notes, const char* key,
                    const char* values_key, std::optional<T> PressNote::*member,
                    const Describe& describe_values) {
  std::vector<std::string> names;
  std::vector<T> values;
  for (const auto& [name, note] : notes)
    if (note.*member) names.push_back(name), values.push_back(*(note.*member));
  if (!fields.has(may(key, !names.empty()))) return;
  fields.texts(key, names);
  describe_values(values_key, values);
  fields.demand(values.size() == names.size(), values_key,
                en::say("has {} entries for {} presses", values.size(), names.size()),
                en::say("one for each press, \"\" for none"));
  for (std::size_t i = 0; i < names.size(); ++i) notes[names[i]].*member = values[i];
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

void describe_all_presses(Fields& fields, PressSet& presses, bool requires_radius) {
  fields.text(may("operator", !presses.operator_name.empty()), presses.operator_name);
  fields.number(may("ball_radius_mm", presses.ball_radius_mm > 0).required_if(requires_radius),
                presses.ball_radius_mm, kRadiusMm);
}

void describe_single_presses(Fields& fields, PressSet& presses) {
  using Key = const char*;
  auto& notes = presses.notes;
  describe_pairs(fields, notes, "other_balls", "other_balls_mm", &PressNote::ball_radius_mm,
                 [&](Key key, auto& radii_mm) { fields.numbers(key, radii_mm, kRadiusMm); });
  describe_pairs(fields, notes, "depths", "depths_mm", &PressNote::depth,
                 [&](Key key, auto& depths) {
                   fields.rows(
                       key, depths,
                       [](GivenDepth& depth) {
                         return std::array{&depth.mm, &depth.sd_mm};
                       },
                       kLengthMm, en::say("must hold two numbers for each press"),
                       en::say("a depth and its standard deviation in mm"));
                 });
  describe_pairs(fields, notes, "steps", "steps_mm", &PressNote::step_mm,
                 [&](Key key, auto& steps_mm) { fields.numbers(key, steps_mm, kLengthMm); });
  describe_pairs(fields, notes, "bodies", "body_files", &PressNote::body,
                 [&](Key key, auto& files) { fields.texts(key, files); });
  describe_pairs(fields, notes, "balls", "balls_mm", &PressNote::ball_mm,
                 [&](Key key, auto& centres) {
                   const Message what = en::say("is not a ball centre in front of the camera"),
                                 advice = en::say("x, y, z in mm");
                   fields.rows(
                       key, centres,
                       [](Eigen::Vector3d& at) {
                         return std::array{&at.x(), &at.y(), &at.z()};
                       },
                       kPositionMm, what, advice);
                   for (const auto& at : centres) fields.demand(at.z() > 0, key, what, advice);
                 });
  describe_pairs(fields, notes, "excluded", "excluded_because", &PressNote::excluded,
                 [&](Key key, auto& reasons) { fields.texts(key, reasons); });
}

static void describe(Fields& fields, PressSet& presses) {
  fields.format(PressSet::kFormat, "");
  describe_all_presses(fields, presses, false);
  describe_single_presses(fields, presses);
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
  const Status read = inputs.read(*content, [&](YamlSection& top) {
    Fields fields(top);
    describe_all_presses(fields, presses, false);
    describe_single_presses(fields, presses);
  });
  if (!read) return read.error();
  return presses;
}

Result<PressSet> PressSet::parse(const std::string& yaml, const fs::path& origin) {
  YamlFile file(origin);
  return read_fields<PressSet>(file, yaml);
}

std::string PressSet::to_yaml() const { return fields_text(*this); }

Status PressSet::save(const fs::path& finger_folder) const {
  return write_file_atomically(finger_folder / kFileName, to_yaml());
}

}  // namespace alltact
