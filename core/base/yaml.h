// Unknown values of a YAML file.
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace YAML {
class Node;
}

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

// A YAML file during reading: its keys, and the treatment of unknown ones.

class YamlSection;

/// A YAML file during reading.
class YamlFile {
 public:
  /// Larger files are refused.
  static constexpr std::size_t kMaxBytes = std::size_t{4} << 20;
  /// Treatment of keys that the reader does not request.
  enum class Unknown { kRetained = 1, kRefused };

  explicit YamlFile(std::filesystem::path path, Unknown policy = Unknown::kRetained);

  /// `reader` requests all keys that it knows, starting at the top section; `content` is the file's
  /// text. Unrequested keys are retained with a warning, or refused. The first problem ends the
  /// reading.
  Status read(const std::string& content, const std::function<void(YamlSection&)>& reader);
  /// Reads the file from the disk.
  Status load(const std::function<void(YamlSection&)>& reader);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  [[nodiscard]] std::vector<Message>& warnings() { return warnings_; }
  [[nodiscard]] UnknownKeys& unknown() { return unknown_; }
  /// Adds the file's line to an error about a key that was read.
  [[nodiscard]] Error located(const Error& error) const;

 private:
  friend class YamlSection;
  [[nodiscard]] Error error(Message what, int line, std::string_view key, Message advice,
                            ErrorKind kind = ErrorKind::kOther) const;
  void count(std::size_t parts);
  void check_unread_keys();

  struct Section;
  std::filesystem::path path_;
  Unknown policy_;
  std::vector<std::shared_ptr<Section>> sections_;  // sections that were read
  std::map<std::string, int> lines_;                // of every key in them, by its full name
  std::size_t parts_ = 0;                           // number of values that were read
  std::vector<Message> warnings_;
  UnknownKeys unknown_;
};

// Strict reader for all YAML files. It checks every value; each error names file, line, key and the
// correct form.

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
  /// Keys that the reader has requested up to now, in the order of the first requests.
  [[nodiscard]] const std::vector<std::string>& requested_keys() const;
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
  [[nodiscard]] std::vector<double> numbers(const std::string& key, std::size_t min_count,
                                            std::size_t max_count, Limits limits);
  [[nodiscard]] std::vector<std::string> texts(const std::string& key);
  /// A list of lists of numbers.
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& key,
                                                      Limits limits = kAnyNumber);
  /// Every key that has a single value, and that value.
  [[nodiscard]] std::map<std::string, std::string> all_texts();

  /// For problems that only the reader detects. An empty key: the entire section.
  [[noreturn]] void refuse(const std::string& key, Message what, Message advice,
                           ErrorKind kind = ErrorKind::kOther) const;
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
  [[nodiscard]] double checked(const std::string& key, const YAML::Node& node, Limits limits,
                               bool is_item) const;
  [[nodiscard]] std::vector<double> numbers_of(const std::string& key, const YAML::Node& list,
                                               Limits limits) const;
  [[nodiscard]] int line_of(const std::string& key) const;
  [[nodiscard]] std::string full_name(const std::string& key) const;

  YamlFile* file_;
  std::shared_ptr<YamlFile::Section> section_;
};

// Deterministic writing of YAML: the same value gives the same bytes.

/// The shortest text that reads back as the same double, always with a point: 24.0, 1.0e-07.
[[nodiscard]] std::string yaml_number(double value);
/// Without quotes only where every reader takes it for a text.
[[nodiscard]] std::string yaml_text(std::string_view text);
/// As yaml_text, but a text in the form of a number may stay without quotes.
[[nodiscard]] std::string yaml_text_or_number(std::string_view text);
/// Returns [a, b, c] from values in YAML.
[[nodiscard]] std::string yaml_list(const std::vector<std::string>& items);
[[nodiscard]] std::string yaml_numbers(const std::vector<double>& values);

/// The keys of a section in order, followed by the unknown ones of the file.
class YamlBlock {
 public:
  /// `name`: of the section ("camera.port"); empty for the top of the file.
  explicit YamlBlock(std::string name) : name_(std::move(name)) {}
  /// `value` as the functions above write it.
  void add(std::string key, std::string value);
  /// Adds unknown keys that add() has not written.
  void add_unknown(const UnknownKeys& unknown);
  [[nodiscard]] bool is_empty() const { return entries_.empty(); }

  /// "camera.port" for the key "port".
  [[nodiscard]] std::string full_name(const std::string& key) const {
    return name_.empty() ? key : name_ + "." + key;
  }

  /// "{a: 1, b: 2}".
  [[nodiscard]] std::string in_braces() const;
  /// "\n  a: 1\n  b: 2" for the indent "  "; a value may be such lines itself.
  [[nodiscard]] std::string on_lines(const std::string& indent) const;
  /// As an entire file: "a: 1\nb: 2\n".
  [[nodiscard]] std::string on_many_lines() const;

 private:
  std::string name_;
  std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace alltact
