#include "core/yaml/yaml_reader.h"

#include "core/either.h"
#include "core/printable.h"
#include "core/typed_number.h"
#include "core/yaml/yaml_parts.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace alltact {
namespace {

Message shown(const YAML::Node& node) {
  if (node.IsSequence()) return en::say("a list");
  if (node.IsMap()) return en::say("a block of keys");
  if (!node.IsScalar()) return en::say("nothing");
  return en::say("'{}'", printable(node.Scalar()));
}

/// Finite; nullopt for anything that is not just a number.
std::optional<double> parsed(const YAML::Node& node) {
  if (!node.IsScalar() || is_quoted(node)) return std::nullopt;
  const auto value = parse_typed_number(node.Scalar());
  return value ? std::optional(*value) : std::nullopt;
}

/// The reason why an ambiguous number, or one with thousands marks, is refused.
std::optional<Message> ambiguity_of(const YAML::Node& node) {
  return node.IsScalar() && !is_quoted(node) ? number_ambiguity(node.Scalar()) : std::nullopt;
}

bool is_within(double value, const Limits& l) {
  return (l.low_open ? value > l.low : value >= l.low) &&
         (l.high_open ? value < l.high : value <= l.high);
}

Message in_words(const Limits& l) {
  if (l.low == kAnyNumber.low && l.high == kAnyNumber.high) return en::say("a number");
  const Message from = l.low_open ? en::say("above") : en::say("from");
  const Message to = l.high_open ? en::say("below") : en::say("up to");
  return en::say("a number {} {:g} and {} {:g}", from, l.low, to, l.high);
}

std::string to_lower_case(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

/// The written key that was probably meant as `key`: equal but for capitals, without its unit
/// ('radius' for 'radius_mm') or with an additional one; else the nearest with the same beginning
/// ('fx' is no error for 'fy'). Empty where there is none.
std::string misspelling_of(const std::string& key, const std::vector<std::string>& written) {
  const auto without_unit = [](const std::string& k) { return k.substr(0, k.rfind('_')); };
  std::vector<std::string> alike;
  for (const std::string& word : written) {
    const std::string small = to_lower_case(word);
    if (small == key || small == without_unit(key) || without_unit(small) == key) return word;
    if (small.substr(0, 2) == key.substr(0, 2)) alike.push_back(word);
  }
  return nearest_word(key, alike);
}

bool is_all_digits(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

Message number_advice() {
  return en::say("a number such as 24.0, with a point and without a unit");
}

}  // namespace

YamlSection::YamlSection(YamlFile& file, const YAML::Node& node, std::string name, int line)
    : file_(&file), section_(std::make_shared<YamlFile::Section>()) {
  section_->name = std::move(name), section_->line = line;
  file.sections_.push_back(section_);
  if (node.IsNull()) return;  // the first required key will be reported as missing
  if (!node.IsMap())
    refuse("",
           en::say("must be a block of 'key: value' lines, not {}", shown(node)),
           en::say("compare with another file of this kind"));
  file.count(node.size() + 1);
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const YAML::Node& key = entry.first;
    const int here = line_of_mark(key.Mark());
    if (!key.IsScalar() || key.Scalar().size() > kLongestYamlKey)
      throw RefusedYaml{file.error(en::say("holds a key that is not a word"),
                                   here,
                                   section_->name,
                                   en::say("one word before each colon"))};
    // In braces and brackets a comma separates entries: {layer_mm: 1,6} has a key '6' without a
    // value.
    if (entry.second.IsNull() && !seen.empty() && is_all_digits(key.Scalar()))
      throw RefusedYaml{file.error(
          en::say("a comma parts the entries here, and '{}' is none", printable(key.Scalar())),
          here,
          full_name(section_->entries.back().key),
          number_advice())};
    if (!seen.insert(key.Scalar()).second)
      throw RefusedYaml{file.error(en::say("is given twice"),
                                   here,
                                   full_name(key.Scalar()),
                                   en::say("leave one of the two"))};
    section_->entries.push_back({key.Scalar(), entry.second, here});
    file.lines_[full_name(key.Scalar())] = here;
  }
}

YamlSection::YamlSection(YamlFile& file, std::shared_ptr<YamlFile::Section> section)
    : file_(&file), section_(std::move(section)) {}

YamlSection YamlSection::top() const {
  return {*file_, file_->sections_.front()};
}

std::string YamlSection::full_name(const std::string& key) const {
  return name().empty() || key.empty() ? name() + key : name() + "." + key;
}

const std::string& YamlSection::name() const {
  return section_->name;
}

void YamlSection::rename(std::string name) {
  section_->name = std::move(name);
}

int YamlSection::line_of(const std::string& key) const {
  for (const Entry& entry : section_->entries)
    if (entry.key == key) return entry.line;
  return section_->line;
}

std::string YamlSection::where(const std::string& key) const {
  return file_->error("", line_of(key), full_name(key), "").where.english();
}

void YamlSection::refuse(const std::string& key, Message what, Message advice) const {
  throw RefusedYaml{file_->error(std::move(what), line_of(key), full_name(key), std::move(advice))};
}

const YamlSection::Entry* YamlSection::find(const std::string& key) const {
  std::vector<std::string>& requested = section_->requested;
  if (std::find(requested.begin(), requested.end(), key) == requested.end())
    requested.push_back(key);
  for (const Entry& entry : section_->entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

bool YamlSection::has(const std::string& key) const {
  return find(key) != nullptr;
}

bool YamlSection::has_list(const std::string& key) const {
  const Entry* entry = find(key);
  return entry != nullptr && entry->value.IsSequence();
}

bool YamlSection::has_section(const std::string& key) const {
  const Entry* entry = find(key);
  return entry != nullptr && entry->value.IsMap();
}

bool YamlSection::has_sections(const std::string& key) const {
  const Entry* entry = find(key);
  return entry != nullptr && entry->value.IsSequence() && entry->value.size() > 0 &&
         entry->value[0].IsMap();
}

std::vector<std::string> YamlSection::keys() const {
  std::vector<std::string> result;
  for (const Entry& entry : section_->entries) result.push_back(entry.key);
  return result;
}

YamlSection::Entry& YamlSection::required(const std::string& key) {
  if (has(key))
    for (Entry& entry : section_->entries)
      if (entry.key == key) return entry.is_read = true, entry;
  std::vector<std::string> others;
  for (const Entry& entry : section_->entries)
    if (!entry.is_read) others.push_back(entry.key);
  const std::string meant = misspelling_of(key, others);
  const Message add = name().empty() ? en::say("add '{}: ...'", key)
                                     : en::say("add '{}: ...' under '{}:'", key, printable(name()));
  throw RefusedYaml{
      file_->error(en::say("is missing"),
                   section_->line,
                   full_name(key),
                   meant.empty() ? add : en::say("write '{}' for '{}'", key, printable(meant)))};
}

YamlSection YamlSection::section(const std::string& key) {
  const Entry& entry = required(key);
  return {*file_, entry.value, full_name(key), entry.line};
}

std::vector<YamlSection> YamlSection::sections(const std::string& key) {
  std::vector<YamlSection> result;
  for (const YAML::Node& item : list(key))
    result.push_back({*file_,
                      item,
                      fmt::format("{}[{}]", full_name(key), result.size()),
                      line_of_mark(item.Mark())});
  return result;
}

std::string YamlSection::text(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsScalar())
    refuse(key, en::say("must be a text, not {}", shown(entry.value)), "");
  return entry.value.Scalar();
}

std::size_t YamlSection::choice(const std::string& key,
                                const std::vector<std::string_view>& words) {
  const YAML::Node& value = required(key).value;
  const std::string given = value.IsScalar() ? value.Scalar() : "";
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end() || !value.IsScalar())
    refuse(key,
           en::say("{} is not known here", shown(value)),
           one_of({words.begin(), words.end()}, given));
  return static_cast<std::size_t>(found - words.begin());
}

double YamlSection::number(const std::string& key, const Message& meaning) {
  const Entry& entry = required(key);
  const auto value = parsed(entry.value);
  if (!value)
    if (const auto ambiguity = ambiguity_of(entry.value)) refuse(key, *ambiguity, number_advice());
  if (!value)
    refuse(
        key, en::say("must be a number, {}, not {}", meaning, shown(entry.value)), number_advice());
  return *value;
}

double YamlSection::checked(const std::string& key,
                            const YAML::Node& node,
                            Limits limits,
                            bool is_item) const {
  const auto value = parsed(node);
  if (value && is_within(*value, limits)) return *value;
  if (!value)
    if (const auto ambiguity = ambiguity_of(node)) refuse(key, *ambiguity, number_advice());
  const Message allowed = in_words(limits);
  if (value == 0.0 && limits.zero_is_absence)
    refuse(key,
           en::say("0 would mean that this is absent, and what is absent is not named"),
           en::say("leave it out, or give {}", allowed));
  refuse(key,
         is_item ? en::say("holds {}, which is not {}", shown(node), allowed)
                 : en::say("must be {}, not {}", allowed, shown(node)),
         value ? Message() : number_advice());
}

double YamlSection::number(const std::string& key, Limits limits) {
  return checked(key, required(key).value, limits, false);
}

double YamlSection::number_or(const std::string& key, double otherwise, Limits limits) {
  return has(key) ? number(key, limits) : otherwise;
}

int YamlSection::integer(const std::string& key, int low, int high) {
  const Entry& entry = required(key);
  const auto value = parsed(entry.value);
  if (!value)
    if (const auto ambiguity = ambiguity_of(entry.value)) refuse(key, *ambiguity, number_advice());
  if (!value || *value != std::floor(*value) || *value < low || *value > high)
    refuse(key,
           en::say("must be a whole number from {} to {}, not {}", low, high, shown(entry.value)),
           "");
  return static_cast<int>(*value);
}

int YamlSection::integer_or(const std::string& key, int otherwise, int low, int high) {
  return has(key) ? integer(key, low, high) : otherwise;
}

const YAML::Node& YamlSection::list(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsSequence())
    refuse(key, en::say("must be a list, not {}", shown(entry.value)), en::say("[..., ...]"));
  file_->count(entry.value.size());
  return entry.value;
}

std::vector<double> YamlSection::numbers_of(const std::string& key,
                                            const YAML::Node& list,
                                            Limits limits) const {
  std::vector<double> result;
  for (const YAML::Node& item : list) result.push_back(checked(key, item, limits, true));
  return result;
}

std::vector<double> YamlSection::numbers(const std::string& key, Limits limits) {
  return numbers_of(key, list(key), limits);
}

std::vector<double> YamlSection::numbers(const std::string& key,
                                         std::size_t min_count,
                                         std::size_t max_count,
                                         Limits limits) {
  std::vector<double> result = numbers(key, limits);
  if (result.size() < min_count || result.size() > max_count)
    refuse(key,
           en::say("this is not a list of the right length"),
           min_count == max_count ? en::say("[{} numbers]", min_count)
                                  : en::say("[{} to {} numbers]", min_count, max_count));
  return result;
}

std::vector<std::string> YamlSection::texts(const std::string& key) {
  std::vector<std::string> result;
  for (const YAML::Node& item : list(key)) {
    if (!item.IsScalar()) refuse(key, en::say("holds {}, which is not a text", shown(item)), "");
    result.push_back(item.Scalar());
  }
  return result;
}

std::vector<std::vector<double>> YamlSection::rows(const std::string& key, Limits limits) {
  std::vector<std::vector<double>> result;
  for (const YAML::Node& row : list(key)) {
    if (!row.IsSequence())
      refuse(
          key, en::say("holds {}, which is not a list", shown(row)), en::say("[[..., ...], ...]"));
    file_->count(row.size());
    result.push_back(numbers_of(key, row, limits));
  }
  return result;
}

std::map<std::string, std::string> YamlSection::all_texts() {
  std::map<std::string, std::string> result;
  for (Entry& entry : section_->entries) {
    if (!entry.value.IsScalar()) continue;
    entry.is_read = true;
    result[entry.key] = entry.value.Scalar();
  }
  return result;
}

}  // namespace alltact
