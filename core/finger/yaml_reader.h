// Strict reading of YAML: every value is looked at, every complaint names file, line and key.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace YAML {
class Node;
}

namespace alltact {

/// A part of a file that this version does not know, kept to be written back.
struct YamlValue {
  enum class Kind { kScalar = 1, kNull, kList, kMap };
  Kind kind = Kind::kNull;
  std::string tag;   ///< as written in the file, empty when there was none
  std::string text;  ///< scalar
  bool is_quoted = false;
  std::vector<YamlValue> items;                            ///< list
  std::vector<std::pair<std::string, YamlValue>> entries;  ///< map, in the order of the file
};
/// By section ("" for the top of the file, "camera", ...), in the order of the file.
using UnknownKeys = std::map<std::string, std::vector<std::pair<std::string, YamlValue>>>;

/// Thrown by YamlSection, inside this folder only, and caught where the file is opened.
struct Refused {
  Error error;
};

/// What is remembered of a file while its sections are read.
struct YamlFile {
  std::filesystem::path path;
  std::map<std::string, int> lines;  ///< of every key that was met, by its full name
  std::vector<std::string> warnings;
  UnknownKeys unknown;

  [[nodiscard]] Error error(std::string what,
                            int line,
                            std::string_view key,
                            std::string advice) const;
};

/// A block of `key: value` lines. All readers throw Refused; those with a default give it when the
/// key is absent, the others refuse that.
class YamlSection {
 public:
  /// The whole of a file; `content` is what it holds. Throws Refused where that is no YAML.
  static YamlSection top(YamlFile& file, const std::string& content);
  YamlSection(YamlFile& file, const YAML::Node& node, std::string name, int line);
  ~YamlSection();
  YamlSection(YamlSection&&) noexcept;
  YamlSection& operator=(YamlSection&&) = delete;

  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] YamlSection section(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key);
  /// One of `words`, by its place among them.
  [[nodiscard]] std::size_t word(const std::string& key,
                                 const std::vector<std::string_view>& words);
  /// `meaning`: what the number is, for the message ("a length in mm").
  [[nodiscard]] double number(const std::string& key, std::string_view meaning);
  [[nodiscard]] int whole_number(const std::string& key, std::string_view meaning);
  [[nodiscard]] std::vector<double> numbers(const std::string& key);
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);
  /// A list of lists of numbers.
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& key);
  /// Every key that has a single value, and that value.
  [[nodiscard]] std::map<std::string, std::string> all_texts();

  /// To be called when all that is known has been read: the rest is kept, and warned of.
  void keep_the_rest();

  [[noreturn]] void refuse(const std::string& key, std::string what, std::string advice) const;

 private:
  struct Entry;
  [[nodiscard]] Entry& required(const std::string& key);
  [[nodiscard]] std::string full_name(const std::string& key) const;
  [[nodiscard]] const YAML::Node& list(const std::string& key);

  YamlFile* file_;
  std::string name_;
  int line_;
  std::vector<Entry> entries_;
};

}  // namespace alltact
