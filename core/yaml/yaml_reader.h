// Strict reader for all YAML files. It checks every value; each error names file, line, key and the
// correct form.
#pragma once

#include "core/yaml/yaml_file.h"

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace YAML {
class Node;
}

namespace alltact {

/// Limits of a number, inclusive; `low_open` and `high_open` exclude the ends.
struct Limits {
  double low, high;
  bool low_open = false, high_open = false;
  bool zero_is_absence = false;  ///< 0 is refused with the sentence that it would mean absence
};
inline constexpr Limits kAnyNumber{std::numeric_limits<double>::lowest(),
                                   std::numeric_limits<double>::max()};

/// A block of `key: value` lines, valid only during YamlFile::read(). An invalid value ends the
/// reader. Functions with `otherwise` return it for an absent key; the others refuse that. Copies
/// refer to the same section.
class YamlSection {
 public:
  [[nodiscard]] bool has(const std::string& key) const;
  [[nodiscard]] bool has_list(const std::string& key) const;
  [[nodiscard]] bool has_section(const std::string& key) const;
  /// A list that begins with a section.
  [[nodiscard]] bool has_sections(const std::string& key) const;
  /// All keys, for sections whose keys are names.
  [[nodiscard]] std::vector<std::string> keys() const;

  [[nodiscard]] YamlSection section(const std::string& key);
  /// A list of sections.
  [[nodiscard]] std::vector<YamlSection> sections(const std::string& key);
  [[nodiscard]] std::string text(const std::string& key);
  /// The index of the value in `words`.
  [[nodiscard]] std::size_t choice(const std::string& key,
                                   const std::vector<std::string_view>& words);
  /// `meaning`: the number's meaning, for the message ("a length in mm").
  [[nodiscard]] double number(const std::string& key, const Message& meaning);
  [[nodiscard]] double number(const std::string& key, Limits limits);
  [[nodiscard]] double number_or(const std::string& key, double otherwise, Limits limits);
  /// From `low` to `high`.
  [[nodiscard]] int integer(const std::string& key, int low, int high);
  [[nodiscard]] int integer_or(const std::string& key, int otherwise, int low, int high);
  [[nodiscard]] std::vector<double> numbers(const std::string& key, Limits limits = kAnyNumber);
  /// Returns `least` to `most` numbers.
  [[nodiscard]] std::vector<double> numbers(const std::string& key,
                                            std::size_t min_count,
                                            std::size_t max_count,
                                            Limits limits);
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);
  /// A list of lists of numbers.
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& key,
                                                      Limits limits = kAnyNumber);
  /// Every key that has a single value, and that value.
  [[nodiscard]] std::map<std::string, std::string> all_texts();

  /// For problems that only the reader detects. An empty key: the entire section.
  [[noreturn]] void refuse(const std::string& key, Message what, Message advice) const;
  /// "file:line: section.key" for errors; of the entire section where `key` is empty.
  [[nodiscard]] std::string where(const std::string& key) const;
  [[nodiscard]] const YamlFile& file() const { return *file_; }
  /// The top section of the file, for values that depend on other sections.
  [[nodiscard]] YamlSection top() const;
  /// "camera.port"; empty for the top of the file.
  [[nodiscard]] const std::string& name() const;
  /// Sets the name of this section for messages, also of those in it.
  void rename(std::string name);

 private:
  friend class YamlFile;
  struct Entry;
  YamlSection(YamlFile& file, const YAML::Node& node, std::string name, int line);
  YamlSection(YamlFile& file, std::shared_ptr<YamlFile::Section> section);
  [[nodiscard]] const Entry* find(const std::string& key) const;
  [[nodiscard]] Entry& required(const std::string& key);
  [[nodiscard]] const YAML::Node& list(const std::string& key);
  [[nodiscard]] double checked(const std::string& key,
                               const YAML::Node& node,
                               Limits limits,
                               bool is_item) const;
  [[nodiscard]] std::vector<double> numbers_of(const std::string& key,
                                               const YAML::Node& list,
                                               Limits limits) const;
  [[nodiscard]] int line_of(const std::string& key) const;
  [[nodiscard]] std::string full_name(const std::string& key) const;

  YamlFile* file_;
  std::shared_ptr<YamlFile::Section> section_;
};

}  // namespace alltact
