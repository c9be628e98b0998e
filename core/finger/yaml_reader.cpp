#include "core/finger/yaml_reader.h"

#include "core/printable.h"

#include <charconv>

#include <yaml-cpp/yaml.h>

namespace alltact {
namespace {

constexpr int kMaxDepth = 20;               // of what is unknown
constexpr std::size_t kMaxParts = 100'000;  // aliases let a short file stand for a huge one
constexpr std::size_t kMaxKeyLength = 200;

int line_of(const YAML::Node& node) {
  return node.Mark().is_null() ? 1 : node.Mark().line + 1;
}

std::string shown(const YAML::Node& node) {
  if (node.IsSequence()) return "a list";
  if (node.IsMap()) return "a block of keys";
  if (!node.IsScalar()) return "nothing";
  return fmt::format("'{}'", printable(node.Scalar()));
}

bool is_quoted(const YAML::Node& node) {
  return node.Tag() == "!";
}

template <class T>
std::optional<T> parsed(const YAML::Node& node) {
  if (!node.IsScalar() || is_quoted(node)) return std::nullopt;
  std::string_view text = node.Scalar();
  if (text.starts_with('+')) text.remove_prefix(1);
  T value{};
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status != std::errc{} || end != text.data() + text.size() || text.empty())
    return std::nullopt;
  if constexpr (std::is_floating_point_v<T>)
    if (!std::isfinite(value)) return std::nullopt;
  return value;
}

/// nullopt where it is too deep, too large or has keys that are no plain words.
std::optional<YamlValue> kept(const YAML::Node& node, int depth, std::size_t& parts) {
  if (depth > kMaxDepth || ++parts > kMaxParts) return std::nullopt;
  YamlValue value;
  if (node.Tag() != "?" && node.Tag() != "!") value.tag = node.Tag();
  if (node.IsScalar()) {
    value.kind = YamlValue::Kind::kScalar;
    value.text = node.Scalar();
    value.is_quoted = is_quoted(node);
  } else if (node.IsSequence()) {
    value.kind = YamlValue::Kind::kList;
    for (const YAML::Node& item : node) {
      auto inner = kept(item, depth + 1, parts);
      if (!inner) return std::nullopt;
      value.items.push_back(std::move(*inner));
    }
  } else if (node.IsMap()) {
    value.kind = YamlValue::Kind::kMap;
    for (const auto& entry : node) {
      if (!entry.first.IsScalar() || entry.first.Scalar().size() > kMaxKeyLength)
        return std::nullopt;
      auto inner = kept(entry.second, depth + 1, parts);
      if (!inner) return std::nullopt;
      value.entries.emplace_back(entry.first.Scalar(), std::move(*inner));
    }
  }
  return value;
}

}  // namespace

struct YamlSection::Entry {
  std::string key;
  YAML::Node value;
  int line;
  bool is_read = false;
};

Error YamlFile::error(std::string what, int line, std::string_view key, std::string advice) const {
  const std::string place = fmt::format("{}:{}", path.string(), line);
  return {std::move(what),
          key.empty() ? place : fmt::format("{}: {}", place, printable(key)),
          std::move(advice)};
}

YamlSection YamlSection::top(YamlFile& file, const std::string& content) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(content);
    if (documents.size() > 1)
      throw Refused{file.error(
          "holds more than one document", line_of(documents[1]), "", "leave out the lines '---'")};
    return {file, documents.empty() ? YAML::Node() : documents[0], "", 1};
  } catch (const YAML::Exception& problem) {
    const int line = problem.mark.is_null() ? 1 : problem.mark.line + 1;
    throw Refused{file.error("this is not YAML: " + problem.msg,
                             line,
                             "",
                             "look at the brackets, quotes and the space before each key")};
  }
}

YamlSection::YamlSection(YamlFile& file, const YAML::Node& node, std::string name, int line)
    : file_(&file), name_(std::move(name)), line_(line) {
  if (node.IsNull()) return;  // the first key that is needed will be missed by its name
  if (!node.IsMap())
    throw Refused{
        file.error(fmt::format("must be a block of 'key: value' lines, not {}", shown(node)),
                   line,
                   name_,
                   "compare with the file of another finger")};
  for (const auto& entry : node) {
    const YAML::Node& key = entry.first;
    if (!key.IsScalar() || key.Scalar().size() > kMaxKeyLength)
      throw Refused{file.error(
          "holds a key that is not a word", line_of(key), name_, "one word before each colon")};
    if (has(key.Scalar())) {
      const int here = line_of(key);
      throw Refused{
          file.error("is given twice", here, full_name(key.Scalar()), "leave one of the two")};
    }
    entries_.push_back({key.Scalar(), entry.second, line_of(key)});
    file.lines[full_name(key.Scalar())] = line_of(key);
  }
}

YamlSection::~YamlSection() = default;
YamlSection::YamlSection(YamlSection&&) noexcept = default;

std::string YamlSection::full_name(const std::string& key) const {
  return name_.empty() ? key : name_ + "." + key;
}

bool YamlSection::has(const std::string& key) const {
  return std::any_of(
      entries_.begin(), entries_.end(), [&](const Entry& entry) { return entry.key == key; });
}

YamlSection::Entry& YamlSection::required(const std::string& key) {
  for (Entry& entry : entries_)
    if (entry.key == key) return entry.is_read = true, entry;
  throw Refused{file_->error("is missing",
                             line_,
                             full_name(key),
                             name_.empty() ? fmt::format("add '{}: ...'", key)
                                           : fmt::format("add '{}: ...' under '{}:'", key, name_))};
}

void YamlSection::refuse(const std::string& key, std::string what, std::string advice) const {
  const auto line = file_->lines.find(full_name(key));
  throw Refused{file_->error(std::move(what),
                             line == file_->lines.end() ? line_ : line->second,
                             full_name(key),
                             std::move(advice))};
}

YamlSection YamlSection::section(const std::string& key) {
  const Entry& entry = required(key);
  return {*file_, entry.value, full_name(key), entry.line};
}

std::string YamlSection::text(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsScalar())
    refuse(key, fmt::format("must be a text, not {}", shown(entry.value)), "");
  return entry.value.Scalar();
}

std::size_t YamlSection::word(const std::string& key, const std::vector<std::string_view>& words) {
  const Entry& entry = required(key);
  if (entry.value.IsScalar()) {
    const auto place = std::find(words.begin(), words.end(), entry.value.Scalar());
    if (place != words.end()) return static_cast<std::size_t>(place - words.begin());
  }
  refuse(key,
         fmt::format("{} is not known here", shown(entry.value)),
         fmt::format("{}", fmt::join(words, " or ")));
}

double YamlSection::number(const std::string& key, std::string_view meaning) {
  const Entry& entry = required(key);
  const auto value = parsed<double>(entry.value);
  if (!value)
    refuse(key,
           fmt::format("must be a number, {}, not {}", meaning, shown(entry.value)),
           "a number such as 24.0, with a point and without a unit");
  return *value;
}

int YamlSection::whole_number(const std::string& key, std::string_view meaning) {
  const Entry& entry = required(key);
  const auto value = parsed<int>(entry.value);
  if (!value)
    refuse(key, fmt::format("must be a whole number, {}, not {}", meaning, shown(entry.value)), "");
  return *value;
}

const YAML::Node& YamlSection::list(const std::string& key) {
  const Entry& entry = required(key);
  if (!entry.value.IsSequence())
    refuse(key, fmt::format("must be a list, not {}", shown(entry.value)), "[..., ...]");
  return entry.value;
}

std::vector<double> YamlSection::numbers(const std::string& key) {
  std::vector<double> result;
  for (const YAML::Node& item : list(key)) {
    const auto value = parsed<double>(item);
    if (!value) refuse(key, fmt::format("holds {}, which is not a number", shown(item)), "");
    result.push_back(*value);
  }
  return result;
}

std::vector<std::string> YamlSection::texts(const std::string& key) {
  std::vector<std::string> result;
  for (const YAML::Node& item : list(key)) {
    if (!item.IsScalar())
      refuse(key, fmt::format("holds {}, which is not a text", shown(item)), "");
    result.push_back(item.Scalar());
  }
  return result;
}

std::vector<std::vector<double>> YamlSection::rows(const std::string& key) {
  std::vector<std::vector<double>> result;
  for (const YAML::Node& row : list(key)) {
    if (!row.IsSequence())
      refuse(key, fmt::format("holds {}, which is not a list", shown(row)), "[[..., ...], ...]");
    std::vector<double>& values = result.emplace_back();
    for (const YAML::Node& item : row) {
      const auto value = parsed<double>(item);
      if (!value) refuse(key, fmt::format("holds {}, which is not a number", shown(item)), "");
      values.push_back(*value);
    }
  }
  return result;
}

std::map<std::string, std::string> YamlSection::all_texts() {
  std::map<std::string, std::string> result;
  for (Entry& entry : entries_) {
    if (!entry.value.IsScalar()) continue;
    entry.is_read = true;
    result[entry.key] = entry.value.Scalar();
  }
  return result;
}

void YamlSection::keep_the_rest() {
  for (const Entry& entry : entries_) {
    if (entry.is_read) continue;
    std::size_t parts = 0;
    auto value = kept(entry.value, 0, parts);
    if (!value) refuse(entry.key, "is not known, and too large or too odd to be kept", "remove it");
    file_->unknown[name_].emplace_back(entry.key, std::move(*value));
    file_->warnings.push_back(
        file_->error("is not known here; it is kept as it is", entry.line, full_name(entry.key), "")
            .sentence());
  }
}

}  // namespace alltact
