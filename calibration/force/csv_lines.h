// Reads lines of comma-separated values, for tables of other programs.
#pragma once

#include "core/typed_number.h"

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Lines without their ends and without the byte order mark that spreadsheets write before them.
/// Semicolons or tabulators separate the cells where the first line has them and no commas.
/// Spreadsheets write this where the comma is the decimal mark.
class CsvLines {
 public:
  explicit CsvLines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
    const CsvLines before = *this;
    auto head = next();
    while (head && head->starts_with('#')) head = next();
    const auto has = [&](char c) { return head && head->find(c) != std::string_view::npos; };
    const char between = has(';') ? ';' : has('\t') && !has(',') ? '\t' : ',';
    const DecimalMark mark = between == ',' ? DecimalMark::kPoint : mark_of(between);
    *this = before;
    between_ = between, writing_.mark = mark;
  }
  /// The next line that is not empty; nullopt at the end.
  [[nodiscard]] std::optional<std::string_view> next() {
    while (!rest_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      std::string_view line = rest_.substr(0, end);
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
      if (line.ends_with('\r')) line.remove_suffix(1);
      if (!line.empty()) return line;
    }
    return std::nullopt;
  }
  /// Number of the line that next() returned, from 1.
  [[nodiscard]] int number() const { return number_; }

  /// Cells without surrounding blanks and quotes. Quotes do not protect commas: no cell of interest
  /// contains one.
  [[nodiscard]] std::vector<std::string_view> cells(std::string_view line) const {
    return cells(line, between_);
  }

  /// A cell as a number; nullopt: no finite number, or more than one.
  [[nodiscard]] std::optional<double> number_in(std::string_view cell) const {
    const auto value = parse_typed_number(cell, writing_);
    return value ? std::optional(*value) : std::nullopt;
  }

 private:
  [[nodiscard]] static std::vector<std::string_view> cells(std::string_view line, char between) {
    std::vector<std::string_view> cells;
    for (;;) {
      const std::size_t end = std::min(line.find(between), line.size());
      std::string_view cell = line.substr(0, end);
      const auto is_around = [](char c) { return c == ' ' || c == '\t' || c == '"'; };
      while (!cell.empty() && is_around(cell.front())) cell.remove_prefix(1);
      while (!cell.empty() && is_around(cell.back())) cell.remove_suffix(1);
      cells.push_back(cell);
      if (end == line.size()) return cells;
      line.remove_prefix(end + 1);
    }
  }

  /// Decimal mark of the remaining lines: the comma where a cell is a number with one, and none
  /// with a point. "1,234" is then no thousand.
  [[nodiscard]] DecimalMark mark_of(char between) {
    const auto is_number_with = [](std::string_view cell, char mark) {
      if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
      const std::size_t at = cell.find(mark);
      return at != std::string_view::npos && cell.find_first_not_of("0123456789") == at &&
             cell.find_first_not_of("0123456789", at + 1) == std::string_view::npos;
    };
    bool has_comma = false;
    while (const auto line = next())
      for (const std::string_view cell : cells(*line, between)) {
        if (is_number_with(cell, '.')) return DecimalMark::kPoint;
        has_comma = has_comma || is_number_with(cell, ',');
      }
    return has_comma ? DecimalMark::kComma : DecimalMark::kPoint;
  }

  std::string_view rest_;
  int number_ = 0;
  char between_ = ',';
  NumberFormat writing_;
};

/// A column's name for comparison: in lower case, without its unit.
[[nodiscard]] std::string csv_column(std::string_view name);

}  // namespace alltact
