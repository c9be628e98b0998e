#include "core/base/yaml.h"

#include "core/base/atomic_file.h"
#include "core/base/letters.h"
#include "core/base/message.h"
#include "core/base/typed_number.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <sstream>

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

namespace alltact {

struct YamlSection::Entry {
  std::string key;
  YAML::Node value;
  int line;
  bool is_read = false;
};

struct YamlFile::Section {
  std::string name;
  int line;
  std::vector<YamlSection::Entry> entries;
  std::vector<std::string> requested;

  /// Requested keys that the section does not have.
  [[nodiscard]] std::vector<std::string> absent() const {
    std::vector<std::string> keys = requested;
    for (const YamlSection::Entry& entry : entries) std::erase(keys, entry.key);
    return keys;
  }
};

namespace {

/// Ends the reading of a file; YamlFile::read() catches it.
struct RefusedYaml {
  Error error;
};

constexpr std::size_t kLongestYamlKey = 200;
constexpr int kMaxDepth = 20;                  // of unknown values
constexpr std::size_t kMaxRetained = 100'000;  // aliases let a short file stand for a huge one
constexpr std::size_t kMaxRead = 1'000'000;

int line_of_mark(const YAML::Mark& mark) { return mark.is_null() ? 1 : mark.line + 1; }

bool is_quoted(const YAML::Node& node) { return node.Tag() == "!"; }

/// Copies an unknown value; nullopt where it is too deep, too large or has keys that are no plain
/// words.
std::optional<YamlValue> copied_value(const YAML::Node& node, int depth, std::size_t& parts) {
  if (depth > kMaxDepth || ++parts > kMaxRetained) return std::nullopt;
  YamlValue value;
  if (node.Tag() != "?" && node.Tag() != "!") value.tag = node.Tag();
  if (node.IsScalar()) {
    value.kind = YamlValue::Kind::kScalar;
    value.text = node.Scalar();
    value.is_quoted = is_quoted(node);
  } else if (node.IsSequence()) {
    value.kind = YamlValue::Kind::kList;
    for (const YAML::Node& item : node) {
      auto inner = copied_value(item, depth + 1, parts);
      if (!inner) return std::nullopt;
      value.items.push_back(std::move(*inner));
    }
  } else if (node.IsMap()) {
    value.kind = YamlValue::Kind::kMap;
    for (const auto& entry : node) {
      if (!entry.first.IsScalar() || entry.first.Scalar().size() > kLongestYamlKey)
        return std::nullopt;
      auto inner = copied_value(entry.second, depth + 1, parts);
      if (!inner) return std::nullopt;
      value.entries.emplace_back(entry.first.Scalar(), std::move(*inner));
    }
  }
  return value;
}

/// Stores the position of a document's begin.
class DocumentStart : public YAML::EventHandler {
 public:
  std::optional<YAML::Mark> mark;

  void OnDocumentStart(const YAML::Mark&) override {}
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& at, YAML::anchor_t) override { note(at); }
  void OnAlias(const YAML::Mark& at, YAML::anchor_t) override { note(at); }
  void OnScalar(const YAML::Mark& at, const std::string&, YAML::anchor_t,
                const std::string&) override {
    note(at);
  }
  void OnSequenceStart(const YAML::Mark& at, const std::string&, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    note(at);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& at, const std::string&, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    note(at);
  }
  void OnMapEnd() override {}

 private:
  void note(const YAML::Mark& at) {
    if (!mark) mark = at;
  }
};

/// The begin of a second document; nullopt: there is none. It reads no further, because yaml-cpp
/// makes endless documents of a stray comma.
std::optional<YAML::Mark> second_document(const std::string& content) {
  std::istringstream stream(content);
  YAML::Parser parser(stream);
  DocumentStart first, second;
  if (!parser.HandleNextDocument(first) || !parser.HandleNextDocument(second)) return std::nullopt;
  return second.mark.value_or(YAML::Mark());
}

}  // namespace

YamlFile::YamlFile(std::filesystem::path path, Unknown policy)
    : path_(std::move(path)), policy_(policy) {}

Error YamlFile::error(Message what, int line, std::string_view key, Message advice,
                      ErrorKind kind) const {
  const std::string location = fmt::format("{}:{}", path_.string(), line);
  return {std::move(what), key.empty() ? location : fmt::format("{}: {}", location, printable(key)),
          std::move(advice), kind};
}

Status YamlFile::load(const std::function<void(YamlSection&)>& reader) {
  const auto content = read_file(path_, kMaxBytes);
  if (!content) return content.error();
  return read(*content, reader);
}

Status YamlFile::read(const std::string& content, const std::function<void(YamlSection&)>& reader) {
  try {
    if (const auto mark = second_document(content))
      return error(en::say("holds more than one document"), line_of_mark(*mark), "",
                   en::say("leave out the lines '---'"));
    YamlSection top(*this, YAML::Load(content), "", 1);
    reader(top);
    check_unread_keys();
    return {};
  } catch (const RefusedYaml& refused) {
    return refused.error;
  } catch (const YAML::Exception& problem) {
    return error(en::say("this is not YAML: {}", printable(problem.msg)),
                 line_of_mark(problem.mark), "",
                 en::say("check the brackets, quotes and the space before each key"));
  } catch (const std::exception& problem) {  // of a library that the reader called
    return Error{Message::typed(problem.what()), path_, ""};
  }
}

Error YamlFile::located(const Error& error) const {
  // For an absent key that another one requires: the nearest block above it.
  std::string key = error.where.english();
  while (!key.empty() && !lines_.contains(key)) {
    const std::size_t dot = key.rfind('.');
    key.resize(dot == std::string::npos ? 0 : dot);
  }
  const int line = key.empty() ? 1 : lines_.at(key);
  return this->error(error.what, line, error.where.english(), error.advice, error.kind);
}

void YamlFile::count(std::size_t parts) {
  parts_ += parts;
  if (parts_ > kMaxRead)
    throw RefusedYaml{
        {en::say("is too large to be read"), path_, en::say("a file with fewer entries")}};
}

void YamlFile::check_unread_keys() {
  struct Rest {
    const Section* section;
    const YamlSection::Entry* entry;
  };
  std::vector<Rest> rest;
  for (const auto& section : sections_)
    for (const YamlSection::Entry& entry : section->entries)
      if (!entry.is_read) rest.push_back({section.get(), &entry});
  std::stable_sort(rest.begin(), rest.end(),
                   [](const Rest& a, const Rest& b) { return a.entry->line < b.entry->line; });
  std::size_t parts = 0;
  for (const auto& [section, entry] : rest) {
    const std::string& key = entry->key;
    const std::string name = section->name.empty() ? key : section->name + "." + key;
    if (policy_ == Unknown::kRefused)
      throw RefusedYaml{
          error(en::say("unknown key '{}'", printable(key)), entry->line, name,
                section->requested.empty()
                    ? Message()
                    : one_of(section->requested, nearest_word(key, section->absent())))};
    auto value = copied_value(entry->value, 0, parts);
    if (!value)
      throw RefusedYaml{error(en::say("is unknown, and too large or too unusual to be stored"),
                              entry->line, name, en::say("remove it"))};
    unknown_[section->name].emplace_back(key, std::move(*value));
    const std::string meant = nearest_word(key, section->absent());
    const Error warning = error(en::say("is not known here; it stays unchanged"), entry->line, name,
                                meant.empty() ? Message() : en::say("'{}'", meant));
    warnings_.push_back(en::say("{}.", warning.message()));
  }
}

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

/// The written key that was probably meant as `key`: equal but for capitals, without its unit
/// ('radius' for 'radius_mm') or with an additional one; else the nearest with the same beginning
/// ('fx' is no error for 'fy'). Empty where there is none.
std::string misspelling_of(const std::string& key, const std::vector<std::string>& written) {
  const auto without_unit = [](const std::string& k) { return k.substr(0, k.rfind('_')); };
  std::vector<std::string> alike;
  for (const std::string& word : written) {
    const std::string small = lowered(word);
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
    refuse("", en::say("must be a block of 'key: value' lines, not {}", shown(node)),
           en::say("compare with another file of this kind"), ErrorKind::kNoBlock);
  file.count(node.size() + 1);
  std::set<std::string> seen;
  for (const auto& entry : node) {
    const YAML::Node& key = entry.first;
    const int here = line_of_mark(key.Mark());
    if (!key.IsScalar() || key.Scalar().size() > kLongestYamlKey)
      throw RefusedYaml{file.error(en::say("holds a key that is not a word"), here, section_->name,
                                   en::say("one word before each colon"))};
    // In braces and brackets a comma separates entries: {layer_mm: 1,6} has a key '6' without a
    // value.
    if (entry.second.IsNull() && !seen.empty() && is_all_digits(key.Scalar()))
      throw RefusedYaml{file.error(
          en::say("a comma separates entries here, and '{}' is none", printable(key.Scalar())),
          here, full_name(section_->entries.back().key), number_advice())};
    if (!seen.insert(key.Scalar()).second)
      throw RefusedYaml{file.error(en::say("is given twice"), here, full_name(key.Scalar()),
                                   en::say("delete one of the two"))};
    section_->entries.push_back({key.Scalar(), entry.second, here});
    file.lines_[full_name(key.Scalar())] = here;
  }
}

YamlSection::YamlSection(YamlFile& file, std::shared_ptr<YamlFile::Section> section)
    : file_(&file), section_(std::move(section)) {}

YamlSection YamlSection::top() const { return {*file_, file_->sections_.front()}; }

std::string YamlSection::full_name(const std::string& key) const {
  return name().empty() || key.empty() ? name() + key : name() + "." + key;
}

const std::string& YamlSection::name() const { return section_->name; }

void YamlSection::rename(std::string name) { section_->name = std::move(name); }

int YamlSection::line_of(const std::string& key) const {
  for (const Entry& entry : section_->entries)
    if (entry.key == key) return entry.line;
  return section_->line;
}

std::string YamlSection::where(const std::string& key) const {
  return file_->error("", line_of(key), full_name(key), "").where.english();
}

void YamlSection::refuse(const std::string& key, Message what, Message advice,
                         ErrorKind kind) const {
  throw RefusedYaml{
      file_->error(std::move(what), line_of(key), full_name(key), std::move(advice), kind)};
}

const YamlSection::Entry* YamlSection::find(const std::string& key) const {
  std::vector<std::string>& requested = section_->requested;
  if (std::find(requested.begin(), requested.end(), key) == requested.end())
    requested.push_back(key);
  for (const Entry& entry : section_->entries)
    if (entry.key == key) return &entry;
  return nullptr;
}

bool YamlSection::has(const std::string& key) const { return find(key) != nullptr; }

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

const std::vector<std::string>& YamlSection::requested_keys() const { return section_->requested; }

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
  throw RefusedYaml{file_->error(
      en::say("is missing"), section_->line, full_name(key),
      meant.empty() ? add : en::say("write '{}' instead of '{}'", key, printable(meant)),
      ErrorKind::kMissingKey)};
}

YamlSection YamlSection::section(const std::string& key) {
  const Entry& entry = required(key);
  return {*file_, entry.value, full_name(key), entry.line};
}

std::vector<YamlSection> YamlSection::sections(const std::string& key) {
  std::vector<YamlSection> result;
  for (const YAML::Node& item : list(key))
    result.push_back({*file_, item, fmt::format("{}[{}]", full_name(key), result.size()),
                      line_of_mark(item.Mark())});
  return result;
}

std::string YamlSection::text(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsScalar())
    refuse(key, en::say("must be text, not {}", shown(entry.value)), "", ErrorKind::kWrongValue);
  return entry.value.Scalar();
}

std::size_t YamlSection::choice(const std::string& key,
                                const std::vector<std::string_view>& words) {
  const YAML::Node& value = required(key).value;
  const std::string given = value.IsScalar() ? value.Scalar() : "";
  const auto found = std::find(words.begin(), words.end(), given);
  if (found == words.end() || !value.IsScalar())
    refuse(key, en::say("{} is not known here", shown(value)),
           one_of({words.begin(), words.end()}, given), ErrorKind::kUnknownWord);
  return static_cast<std::size_t>(found - words.begin());
}

double YamlSection::number(const std::string& key, const Message& meaning) {
  const Entry& entry = required(key);
  const auto value = parsed(entry.value);
  if (!value)
    if (const auto ambiguity = ambiguity_of(entry.value)) refuse(key, *ambiguity, number_advice());
  if (!value)
    refuse(key, en::say("must be a number, {}, not {}", meaning, shown(entry.value)),
           number_advice(), ErrorKind::kWrongValue);
  return *value;
}

double YamlSection::checked(const std::string& key, const YAML::Node& node, Limits limits,
                            bool is_item) const {
  const auto value = parsed(node);
  if (value && is_within(*value, limits)) return *value;
  if (!value)
    if (const auto ambiguity = ambiguity_of(node)) refuse(key, *ambiguity, number_advice());
  const Message allowed = in_words(limits);
  if (value == 0.0 && limits.zero_is_absence)
    refuse(key, en::say("0 means that it is absent; leave out what is absent"),
           en::say("leave it out, or enter {}", allowed));
  refuse(key,
         is_item ? en::say("holds {}, which is not {}", shown(node), allowed)
                 : en::say("must be {}, not {}", allowed, shown(node)),
         value ? Message() : number_advice(),
         is_item ? ErrorKind::kWrongItem : ErrorKind::kWrongValue);
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
    refuse(key, en::say("must be an integer from {} to {}, not {}", low, high, shown(entry.value)),
           "", ErrorKind::kWrongValue);
  return static_cast<int>(*value);
}

int YamlSection::integer_or(const std::string& key, int otherwise, int low, int high) {
  return has(key) ? integer(key, low, high) : otherwise;
}

const YAML::Node& YamlSection::list(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsSequence())
    refuse(key, en::say("must be a list, not {}", shown(entry.value)), en::say("[..., ...]"),
           ErrorKind::kNoList);
  file_->count(entry.value.size());
  return entry.value;
}

std::vector<double> YamlSection::numbers_of(const std::string& key, const YAML::Node& list,
                                            Limits limits) const {
  std::vector<double> result;
  for (const YAML::Node& item : list) result.push_back(checked(key, item, limits, true));
  return result;
}

std::vector<double> YamlSection::numbers(const std::string& key, Limits limits) {
  return numbers_of(key, list(key), limits);
}

std::vector<double> YamlSection::numbers(const std::string& key, std::size_t min_count,
                                         std::size_t max_count, Limits limits) {
  std::vector<double> result = numbers(key, limits);
  if (result.size() < min_count || result.size() > max_count)
    refuse(key, en::say("this is not a list of the right length"),
           min_count == max_count ? en::say("[{} numbers]", min_count)
                                  : en::say("[{} to {} numbers]", min_count, max_count));
  return result;
}

std::vector<std::string> YamlSection::texts(const std::string& key) {
  std::vector<std::string> result;
  for (const YAML::Node& item : list(key)) {
    if (!item.IsScalar()) refuse(key, en::say("holds {}, which is not text", shown(item)), "");
    result.push_back(item.Scalar());
  }
  return result;
}

std::vector<std::vector<double>> YamlSection::rows(const std::string& key, Limits limits) {
  std::vector<std::vector<double>> result;
  for (const YAML::Node& row : list(key)) {
    if (!row.IsSequence())
      refuse(key, en::say("holds {}, which is not a list", shown(row)),
             en::say("[[..., ...], ...]"));
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

namespace {

bool begins_word(char c) { return is_letter(c) || c == '_'; }

/// True when YAML gives no special meaning to any character, also inside a list.
bool is_harmless(std::string_view text) {
  if (text.empty() || text.front() == ' ' || text.back() == ' ') return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return begins_word(c) || is_digit(c) ||
           std::string_view(" ./+-()").find(c) != std::string_view::npos;
  });
}

bool is_reserved(std::string_view text) {
  static constexpr std::array kWords{"true", "false", "yes",  "no",  "on", "off",
                                     "y",    "n",     "null", "nan", "inf"};
  return std::find(kWords.begin(), kWords.end(), lowered(std::string(text))) != kWords.end();
}

std::string in_quotes(std::string_view text) {
  std::string result = "\"";
  for (char c : text) {
    switch (c) {
      case '"':
        result += "\\\"";
        break;
      case '\\':
        result += "\\\\";
        break;
      case '\n':
        result += "\\n";
        break;
      case '\t':
        result += "\\t";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 || c == 0x7F) {
          result += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
          result += c;
        }
    }
  }
  return result + '"';
}

std::string written(const YamlValue& value) {
  const std::string tag = value.tag.empty() ? "" : "!<" + value.tag + "> ";
  switch (value.kind) {
    case YamlValue::Kind::kNull:
      return tag + "~";
    case YamlValue::Kind::kScalar:
      return tag + (value.is_quoted ? in_quotes(value.text) : yaml_text_or_number(value.text));
    case YamlValue::Kind::kList: {
      std::vector<std::string> items;
      for (const YamlValue& item : value.items) items.push_back(written(item));
      return tag + yaml_list(items);
    }
    case YamlValue::Kind::kMap: {
      std::vector<std::string> entries;
      for (const auto& [key, inner] : value.entries)
        entries.push_back(yaml_text(key) + ": " + written(inner));
      return fmt::format("{}{{{}}}", tag, fmt::join(entries, ", "));
    }
  }
  return {};
}

}  // namespace

std::string yaml_number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find('.') != std::string::npos) return text;
  const std::size_t exponent = text.find('e');
  // Without the point some readers take 1e-07 for a text.
  text.insert(exponent == std::string::npos ? text.size() : exponent, ".0");
  return text;
}

std::string yaml_text(std::string_view text) {
  const bool is_plain = is_harmless(text) && begins_word(text.front()) && !is_reserved(text);
  return is_plain ? std::string(text) : in_quotes(text);
}

std::string yaml_text_or_number(std::string_view text) {
  const bool is_signed = text.size() > 1 && text.front() == '-' && is_digit(text[1]);
  const bool is_null = text == "null" || text == "Null" || text == "NULL";
  const bool is_plain = is_harmless(text) && !is_null &&
                        (begins_word(text.front()) || is_digit(text.front()) || is_signed);
  return is_plain ? std::string(text) : in_quotes(text);
}

std::string yaml_list(const std::vector<std::string>& items) {
  return fmt::format("[{}]", fmt::join(items, ", "));
}

std::string yaml_numbers(const std::vector<double>& values) {
  std::vector<std::string> items;
  for (double value : values) items.push_back(yaml_number(value));
  return yaml_list(items);
}

void YamlBlock::add(std::string key, std::string value) {
  entries_.emplace_back(std::move(key), std::move(value));
}

void YamlBlock::add_unknown(const UnknownKeys& unknown) {
  const auto section = unknown.find(name_);
  if (section == unknown.end()) return;
  for (const auto& [key, value] : section->second) {
    const auto same = [&key = key](const auto& entry) { return entry.first == key; };
    if (std::none_of(entries_.begin(), entries_.end(), same)) add(key, written(value));
  }
}

std::string YamlBlock::in_braces() const {
  std::vector<std::string> parts;
  for (const auto& [key, value] : entries_) parts.push_back(yaml_text(key) + ": " + value);
  return fmt::format("{{{}}}", fmt::join(parts, ", "));
}

std::string YamlBlock::on_lines(const std::string& indent) const {
  std::string text;
  for (const auto& [key, value] : entries_)
    text += fmt::format("\n{}{}:{}{}", indent, yaml_text(key), value.starts_with('\n') ? "" : " ",
                        value);
  return text;
}

std::string YamlBlock::on_many_lines() const {
  return is_empty() ? "" : on_lines("").substr(1) + "\n";
}

}  // namespace alltact
