// Tables of numbers as other programs write them: CSV of spreadsheets, of gauges and of scripts.
//
// What a file does not state is found by looking at it:
//   encoding   UTF-8 or UTF-16 (either byte order), with or without byte order mark; else
//              Windows-1252, or GB18030 where more names of the head are known in it
//   lines      LF, CRLF or CR; empty ones and those of separators only are skipped, and those that
//              begin with '#' or '%' are remarks
//   separator  comma, semicolon, tabulator, '|' or blanks: the one with which most names of the
//              head are known; "sep=;" in the first line
//   head       the line with most known names, also behind lines of other text, or in a remark
//   mark       the comma is decimal where a number contains one that separates no thousands, such
//              as 0,5 between semicolons
//   units      in the head, "t_ms", "Fx [N]", "Time/s", "t in ms", or in the line below
//   quotes     of RFC 4180
// Numbers are read independently of the locale. What has two meanings is refused.
//
//   auto table = Table::open(bytes, file, {{{"t_s", Measure::kTime, {"time", "zeit"}}}, advice});
//   const int t = table->find("t_s");
//   for (auto more = table->next(); ; more = table->next()) {
//     if (!more) return more.error();
//     if (!*more) break;
//     const auto seconds = table->time_s(t);
//   }
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"
#include "core/base/typed_number.h"
#include "core/base/units.h"

#include <cstdint>
#include <deque>
#include <filesystem>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace alltact {

/// A column that a reader of tables knows.
struct TableColumnKind {
  std::string key;  ///< its documented name with its documented unit: "t_s", "fx_n", "day"
  std::optional<Measure> measure = {};  ///< empty: text
  /// Other names, in lower case without blanks and "_-.:#". The key without its unit is one, too.
  std::vector<std::string_view> names = {};
  /// Names that apply only with a unit of the measure, such as "x" of "X [N]".
  std::vector<std::string_view> names_with_unit = {};
  bool is_numbered = false;   ///< u0, u1, u2, ...
  MeasurementUnit unit = {};  ///< of a column without one; that of the measure by default
};

struct TableFormat {
  std::vector<TableColumnKind> kinds;
  Message advice;           ///< of errors of the head
  Message row_advice = {};  ///< of errors of a row; empty: to remove or to correct it
};

class Table {
 public:
  struct Column {
    std::string name;                     ///< as in the file, with its unit
    int kind = -1;                        ///< index of format.kinds; -1: unknown
    int number = -1;                      ///< of "u7"; -1: none
    std::optional<MeasurementUnit> unit;  ///< given by the file
  };

  /// Finds encoding, separator, head and decimal mark. `bytes` must outlive the table.
  /// Errors: an empty file; a workbook or another file that is no text; no head; two columns of one
  /// kind; an unknown unit; two units of a column.
  static Result<Table> open(std::string_view bytes, const std::filesystem::path& origin,
                            TableFormat format);

  [[nodiscard]] const std::vector<Column>& columns() const { return columns_; }
  /// Index of the column of this kind; -1: none.
  [[nodiscard]] int find(std::string_view key, int number = -1) const;

  /// Treats a column as unknown: another one takes precedence.
  void ignore(std::string_view key);

  /// Advances to the next row; false: there is none. Errors: more or fewer cells than names (empty
  /// cells at the end do not count, and a last column "Comment" may be absent); a quote that is not
  /// closed; the file ends within a row: its last line has no end, and fewer cells or digits.
  [[nodiscard]] Result<bool> next();
  /// Line of the row in the file, from 1.
  [[nodiscard]] int line() const { return row_line_; }

  /// A cell of the row without blanks around it, in UTF-8.
  [[nodiscard]] std::string_view text(int column) const;
  /// In the unit of the column's measure; finite.
  [[nodiscard]] Result<double> number(int column) const;
  /// The digits of a number as std::from_chars reads them, in the unit of the file: a double may
  /// hold fewer. Errors: those of number().
  [[nodiscard]] Result<std::string> digits(int column) const;
  /// A time in s: a number in the column's unit (without one: seconds since 1970 in ms, us or ns
  /// where they can be nothing else), or a time stamp, with the column `date` in front of a time of
  /// day (-1: none). In all rows of the same form. 0 is 1970-01-01 or midnight.
  [[nodiscard]] Result<double> time_s(int column, int date = -1);
  /// A time in ns: an integer in ns where the column states no unit. Exact in ns.
  [[nodiscard]] Result<std::int64_t> time_ns(int column) const;
  /// True where time_s() read time stamps.
  [[nodiscard]] bool has_time_stamps() const { return time_.is_stamp; }

  [[nodiscard]] Error wrong_head(Message what) const;
  /// An error of the row, or of one of its cells.
  [[nodiscard]] Error wrong(Message what, int column = -1) const;
  /// The error of a column that is missing, which lists those that were found.
  [[nodiscard]] Error missing(const std::string& key) const;

  /// A sentence on what was found: "Read a.csv as semicolon-separated with decimal commas: t_s from
  /// 'Zeit [ms]' in ms, fx_n from 'Fx [N]'." Complete after the last row.
  [[nodiscard]] Message understood() const;
  /// What may be a mistake: the file's last line has no end. Complete after the last row.
  [[nodiscard]] const std::vector<Message>& remarks() const { return remarks_; }

 private:
  struct Cursor {
    std::string_view text;
    std::size_t at = 0;
    int line = 1;
  };
  enum class Line { kEnd, kRemark, kRow, kOpenQuote, kTextBehindQuote };
  struct Head {
    std::size_t known = 0;
    bool is_remark = false;
    double consistent = -1;  ///< fraction of the lines behind it with as many cells
    char separator = ',';
    std::vector<std::string> cells;
    Cursor behind;
    int line = 1;
  };
  struct Known {
    Column column;
    std::string foreign_unit;  ///< that the measure does not have: "mm" of "Fx [mm]"
  };
  struct TimeForm {
    bool is_known = false, is_stamp = false, has_date = false, has_zone = false;
    bool is_since_1970 = false;  ///< by the size of the numbers
    std::string first_day;
  };

  Table(std::filesystem::path origin, TableFormat format)
      : origin_(std::move(origin)), format_(std::move(format)) {}

  [[nodiscard]] Line read_line(Cursor& cursor, char separator);
  [[nodiscard]] std::optional<Known> known(const std::string& cell) const;
  [[nodiscard]] const TableColumnKind* kind_of(const Column& column) const;
  [[nodiscard]] std::optional<Head> head_with(char separator);
  [[nodiscard]] Result<Head> find_head();
  [[nodiscard]] Status name_columns(const Head& head);
  [[nodiscard]] Status take_units_line();
  void find_decimal_mark();
  [[nodiscard]] Result<double> stamp_s(int column, int date, bool is_first);
  [[nodiscard]] Error other_time_form(int column) const;

  std::filesystem::path origin_;
  TableFormat format_;
  std::vector<std::string> bases_;  ///< names of format_.kinds without their units
  std::string_view text_;
  std::unique_ptr<std::string> decoded_;  ///< where the file is not UTF-8
  std::string encoding_;                  ///< empty: UTF-8
  char separator_ = ',';
  DecimalMark mark_ = DecimalMark::kPoint;
  std::vector<Column> columns_;
  int head_line_ = 1;
  Cursor cursor_;
  int row_line_ = 0;
  std::vector<std::string_view> cells_;
  std::deque<std::string> unquoted_;  ///< cells with doubled quotes
  TimeForm time_;
  std::optional<std::size_t> digits_behind_;  ///< of the last cell, where the same in all rows
  std::size_t row_count_ = 0;
  std::vector<Message> remarks_;
};

/// A cell as other programs read it: in quotes where it needs them.
[[nodiscard]] std::string table_cell(std::string_view text);
/// The text of such a cell.
[[nodiscard]] std::string table_cell_text(std::string_view cell);

}  // namespace alltact
