// Lines of comma-separated values, for tables that other programs wrote.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// Without the line's end and, at the file's beginning, the byte order mark that spreadsheets
/// write.
class CsvLines {
 public:
  explicit CsvLines(std::string_view text) : rest_(text) {
    if (rest_.starts_with("\xEF\xBB\xBF")) rest_.remove_prefix(3);
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
  /// Of the line that next() gave, from 1.
  [[nodiscard]] int number() const { return number_; }

 private:
  std::string_view rest_;
  int number_ = 0;
};

/// Cells without the blanks and quotes around them. Quotes do not hide commas: no cell that is
/// read holds one.
[[nodiscard]] inline std::vector<std::string_view> csv_cells(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t end = std::min(line.find(','), line.size());
    std::string_view cell = line.substr(0, end);
    const auto is_around = [](char c) { return c == ' ' || c == '\t' || c == '"'; };
    while (!cell.empty() && is_around(cell.front())) cell.remove_prefix(1);
    while (!cell.empty() && is_around(cell.back())) cell.remove_suffix(1);
    cells.push_back(cell);
    if (end == line.size()) return cells;
    line.remove_prefix(end + 1);
  }
}

/// nullopt: no finite number, or more than one.
[[nodiscard]] inline std::optional<double> csv_number(std::string_view cell) {
  if (cell.starts_with('+')) cell.remove_prefix(1);
  double value = 0;
  const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (status != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// As columns are compared: in small letters, without a unit behind.
[[nodiscard]] std::string csv_column(std::string_view name);

}  // namespace alltact
