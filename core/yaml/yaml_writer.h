// Writing YAML so that the same value gives the same bytes.
#pragma once

#include "core/yaml/yaml_value.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace alltact {

/// Shortest text that reads back as the same double, always with a point: 24.0, 1.0e-07.
[[nodiscard]] std::string yaml_number(double value);
/// Without quotes only where every reader takes it for a text.
[[nodiscard]] std::string yaml_text(std::string_view text);
/// As yaml_text, but what looks like a number may stay one.
[[nodiscard]] std::string yaml_text_or_number(std::string_view text);
/// [a, b, c] of what is written already.
[[nodiscard]] std::string yaml_list(const std::vector<std::string>& items);
[[nodiscard]] std::string yaml_numbers(const std::vector<double>& values);

/// The keys of a section in order, with the unknown ones of the file behind them.
class YamlBlock {
 public:
  explicit YamlBlock(std::string name) : name_(std::move(name)) {}
  /// `value` as the functions above write it.
  void add(std::string key, std::string value);
  /// Unknown keys that add() has not seen.
  void add_unknown(const UnknownKeys& unknown);
  [[nodiscard]] bool is_empty() const { return entries_.empty(); }

  /// "{a: 1, b: 2}".
  [[nodiscard]] std::string in_braces() const;
  /// "name: {a: 1, b: 2}\n".
  [[nodiscard]] std::string on_one_line() const;
  /// "name:\n  a: 1\n  b: 2\n"; without the name and not indented when the name is empty.
  [[nodiscard]] std::string on_many_lines() const;

 private:
  std::string name_;
  std::vector<std::pair<std::string, std::string>> entries_;
};

}  // namespace alltact
