// Definitions shared by the .cpp files of the reader.
#pragma once

#include "core/base/yaml.h"

#include <string>
#include <vector>

#include <yaml-cpp/yaml.h>

namespace alltact {

inline constexpr std::size_t kLongestYamlKey = 200;

/// Ends the reading of a file; YamlFile::read() catches it.
struct RefusedYaml {
  Error error;
};

inline int line_of_mark(const YAML::Mark& mark) { return mark.is_null() ? 1 : mark.line + 1; }

inline bool is_quoted(const YAML::Node& node) { return node.Tag() == "!"; }

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

}  // namespace alltact
