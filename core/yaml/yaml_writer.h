// Deterministic writing of YAML: the same value gives the same bytes.
#pragma once

#include "core/yaml/yaml_value.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alltact {

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
  explicit YamlBlock(std::string name) : name_(std::move(name)) {}
  /// `value` as the functions above write it.
  void add(std::string key, std::string value);
  /// Adds unknown keys that add() has not written.
  void add_unknown(const UnknownKeys& unknown);
  [[nodiscard]] bool is_empty() const { return entries_.empty(); }

  /// "{a: 1, b: 2}".
  [[nodiscard]] std::string in_braces() const;
  /// "name: {a: 1, b: 2}\n".
  [[nodiscard]] std::string on_one_line() const;
  /// "name:
  ///   a: 1
  ///   b: 2
  /// "; without name and indent when the name is empty.
  [[nodiscard]] std::string on_many_lines() const;

 private:
  std::string name_;
  std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace alltact
