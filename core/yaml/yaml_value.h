// Unknown values of a YAML file.
#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace alltact {

/// A value that this version does not know, retained to be written back.
struct YamlValue {
  enum class Kind { kScalar = 1, kNull, kList, kMap };
  // Not here: clang 14 needs its entries before the type is complete.
  YamlValue();
  Kind kind = Kind::kNull;
  std::string tag;   ///< as written in the file, empty when there was none
  std::string text;  ///< scalar
  bool is_quoted = false;
  std::vector<YamlValue> items;                            ///< list
  std::vector<std::pair<std::string, YamlValue>> entries;  ///< map, in the order of the file
};
inline YamlValue::YamlValue() = default;

/// By section ("" for the top of the file, "camera", ...), in the order of the file.
using UnknownKeys = std::map<std::string, std::vector<std::pair<std::string, YamlValue>>>;

}  // namespace alltact
