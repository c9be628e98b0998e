// Layouts of the markers and forces of a gauge, row by row: the training data of a force model, and
// which rows are held out together.
#pragma once

#include "core/base/result.h"
#include "core/base/typed_number.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A table is a CSV file (commas, '.' in numbers) whose first line names the columns. The case of
/// names is ignored, and their unit (_px, _mm, _n, _s) is optional:
///   u0, v0, u1, v1, ...   px, the markers by number (x00, y00, ... as well); empty: not seen
///   seen0, seen1, ...     1 or 0; absent: markers with a position are seen
///   fx_n, fy_n[, fz_n]    N, force on the finger
///   along_mm, across_mm   position of the contact, from the face's base and its middle; both or
///                         neither; empty: unknown
///   t_s                   time
///   block, day, indenter  names of the row's groups: pressed in one go, on one day, with one tool;
///                         the rows of a group must stay on one side of a split
///   frame                 name of the image
/// Other columns are ignored.
struct ForceTable {
  static constexpr std::size_t kMinRows = 20;
  static constexpr std::size_t kMaxBytes = std::size_t{1} << 30;

  int marker_count = 0;
  int axes = 2;                 ///< 2: Fx, Fy; 3: Fz too
  Eigen::MatrixXd layouts;      ///< one row a frame, (u0, v0, ...), px; 0 where not seen
  Eigen::MatrixXd seen;         ///< 1 or 0, one column a marker
  Eigen::MatrixXd force_N;      ///< one column an axis
  Eigen::MatrixXd position_mm;  ///< along and across, NaN where unknown; no rows: never known
  Eigen::VectorXd time_s;       ///< empty: unknown
  std::vector<std::string> block, day, indenter, frame;  ///< empty: not given
  std::vector<std::string> ignored_columns;              ///< columns

  [[nodiscard]] Eigen::Index rows() const { return force_N.rows(); }
  [[nodiscard]] bool has_position() const { return position_mm.rows() > 0; }

  /// Errors name file, line and column: missing or repeated columns, a cell that is no finite
  /// number, lines with too few cells, and those of check().
  static Result<ForceTable> parse(std::string_view csv, const std::filesystem::path& origin);
  static Result<ForceTable> load(const std::filesystem::path& file);
  /// Parses a part of the training data, such as pushes in one direction: without check(), but with
  /// at least one row.
  static Result<ForceTable> parse_part(std::string_view csv, const std::filesystem::path& origin);
  /// Joins several tables, each block named after its file where there are several. Errors: those
  /// of parse_part, different numbers of markers or axes, and those of check() of the joined table.
  static Result<ForceTable> load_all(const std::vector<std::filesystem::path>& files);
  /// Checks that a model can be learnt: at least kMinRows rows, changing forces, moving markers.
  /// An fz that is exactly 0 everywhere is ignored: gauges of one direction write it so.
  [[nodiscard]] Status check(const std::filesystem::path& origin);
  /// The table as text, which load() reads as the same values.
  [[nodiscard]] std::string to_csv() const;
};

// Which rows of a force table are held out together.

/// Neighbouring rows of a recording are nearly identical, so single held-out rows are no
/// independent test. kRandom holds out single rows, for comparison.
enum class ForceSplit { kBlock = 1, kDay, kIndenter, kRandom };
inline constexpr std::array<std::string_view, 4> kForceSplits{"block", "day", "indenter", "random"};

/// `of`: the fold of each row in which it is held out, from 0.
struct ForceFolds {
  std::vector<int> of;
  int count = 0;
  bool by_time = false;  ///< the table has no blocks: stretches of consecutive rows
  [[nodiscard]] std::vector<Eigen::Index> rows_in(int fold) const;
  [[nodiscard]] std::vector<Eigen::Index> rows_without(int fold) const;
};

/// By block: the table's blocks, or kStretches stretches of rows; more than kMaxFolds groups share
/// folds. Errors: a table without days or indenters, or with only one.
[[nodiscard]] Result<ForceFolds> force_folds(const ForceTable& table, ForceSplit split,
                                             std::uint64_t seed);
inline constexpr int kStretches = 5, kMaxFolds = 10;

/// A random permutation of 0 to n - 1 by seed and purpose.
[[nodiscard]] std::vector<Eigen::Index> drawn_order(Eigen::Index n, std::uint64_t seed,
                                                    std::string_view who, std::uint32_t which = 0);

// Reads lines of comma-separated values, for tables of other programs.

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
