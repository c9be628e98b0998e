// Files of other programs as a tree of values, whichever syntax they have.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A value, list or map of a foreign file, as written: nothing is interpreted.
struct ValueTree {
  enum class Kind { kText = 1, kList, kMap };
  Kind kind = Kind::kText;
  std::string key;   ///< in a map; empty elsewhere
  std::string text;  ///< of a kText; numbers as well. Empty for null
  std::string tag;   ///< of YAML, or the attribute type_id of XML: "opencv-matrix"
  int line = 0;      ///< in the file, from 1; 0: unknown
  /// Of a list in lines: its last item ends the file without a line break, as in a truncated file.
  bool is_cut = false;
  std::vector<ValueTree> children;

  [[nodiscard]] bool is_map() const { return kind == Kind::kMap; }
  /// The child with this key; null where there is none.
  [[nodiscard]] const ValueTree* find(std::string_view name) const;
};

/// Parses YAML (also as OpenCV writes it, with '%YAML:1.0' and tags), JSON, XML as OpenCV writes
/// it, Python's dictionaries, and properties of an object as Matlab prints them ('Name: [1 2]',
/// 'Name = [1 2; 3 4];'). `origin` is the file's name in errors.
/// The content decides, not the name. Errors: no text; none of these; a key that occurs twice in a
/// map; more than one document; nested more than 50 deep; more than 500,000 values.
[[nodiscard]] Result<ValueTree> parse_values(std::string content,
                                             const std::filesystem::path& origin);

}  // namespace alltact
