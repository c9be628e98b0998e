#include "core/yaml/yaml_file.h"

#include "core/either.h"
#include "core/io/atomic_file.h"
#include "core/printable.h"
#include "core/yaml/yaml_parts.h"

#include <algorithm>
#include <optional>
#include <sstream>

#include <yaml-cpp/eventhandler.h>

namespace alltact {
namespace {

constexpr int kMaxDepth = 20;                  // of unknown values
constexpr std::size_t kMaxRetained = 100'000;  // aliases let a short file stand for a huge one
constexpr std::size_t kMaxRead = 1'000'000;

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
  void OnScalar(const YAML::Mark& at,
                const std::string&,
                YAML::anchor_t,
                const std::string&) override {
    note(at);
  }
  void OnSequenceStart(const YAML::Mark& at,
                       const std::string&,
                       YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    note(at);
  }
  void OnSequenceEnd() override {}
  void OnMapStart(const YAML::Mark& at,
                  const std::string&,
                  YAML::anchor_t,
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

Error YamlFile::error(Message what, int line, std::string_view key, Message advice) const {
  const std::string location = fmt::format("{}:{}", path_.string(), line);
  return {std::move(what),
          key.empty() ? location : fmt::format("{}: {}", location, printable(key)),
          std::move(advice)};
}

Status YamlFile::load(const std::function<void(YamlSection&)>& reader) {
  const auto content = read_file(path_, kMaxBytes);
  if (!content) return content.error();
  return read(*content, reader);
}

Status YamlFile::read(const std::string& content, const std::function<void(YamlSection&)>& reader) {
  try {
    if (const auto mark = second_document(content))
      return error(en::say("holds more than one document"),
                   line_of_mark(*mark),
                   "",
                   en::say("leave out the lines '---'"));
    YamlSection top(*this, YAML::Load(content), "", 1);
    reader(top);
    check_unread_keys();
    return {};
  } catch (const RefusedYaml& refused) {
    return refused.error;
  } catch (const YAML::Exception& problem) {
    return error(en::say("this is not YAML: {}", printable(problem.msg)),
                 line_of_mark(problem.mark),
                 "",
                 en::say("look at the brackets, quotes and the space before each key"));
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
  return this->error(error.what, line, error.where.english(), error.advice);
}

void YamlFile::count(std::size_t parts) {
  parts_ += parts;
  if (parts_ > kMaxRead)
    throw RefusedYaml{
        {en::say("is too large to be read"), path_, en::say("a file of fewer entries")}};
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
  std::stable_sort(rest.begin(), rest.end(), [](const Rest& a, const Rest& b) {
    return a.entry->line < b.entry->line;
  });
  std::size_t parts = 0;
  for (const auto& [section, entry] : rest) {
    const std::string& key = entry->key;
    const std::string name = section->name.empty() ? key : section->name + "." + key;
    if (policy_ == Unknown::kRefused)
      throw RefusedYaml{
          error(en::say("unknown key '{}'", printable(key)),
                entry->line,
                name,
                section->requested.empty()
                    ? Message()
                    : one_of(section->requested, nearest_word(key, section->absent())))};
    auto value = copied_value(entry->value, 0, parts);
    if (!value)
      throw RefusedYaml{error(en::say("is not known, and too large or too odd to be kept"),
                              entry->line,
                              name,
                              en::say("remove it"))};
    unknown_[section->name].emplace_back(key, std::move(*value));
    const std::string meant = nearest_word(key, section->absent());
    const Error warning = error(en::say("is not known here; it is kept as it is"),
                                entry->line,
                                name,
                                meant.empty() ? Message() : en::say("'{}'", meant));
    warnings_.push_back(en::say("{}.", warning.message()));
  }
}

}  // namespace alltact
