#include "core/base/table.h"

#include "core/base/letters.h"
#include "core/base/text_encoding.h"
#include "core/base/time_stamp.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>
#include <utility>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr char kBlanks = ' ';       // separator: one or more blanks
constexpr char kWideBlanks = '\v';  // two or more blanks, or a tabulator; names contain one blank
constexpr std::array<char, 6> kSeparators{'\t', ';', ',', '|', kWideBlanks, kBlanks};
constexpr std::size_t kHeadLines = 100, kSampleLines = 150;
constexpr std::size_t kListedNames = 12;
/// So many rows end in as many digits behind the mark by chance rarely: a last one with fewer is
/// cut off.
constexpr std::size_t kRowsOfOneForm = 5;

bool is_blanks(char separator) { return separator == kBlanks || separator == kWideBlanks; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

constexpr std::string_view kAround = " \t";

// Names of columns.

/// In lower case, without what people write between words.
std::string plain_name(std::string_view name) {
  constexpr std::string_view kBetween = " _-.:#'\"\t\r\n";
  std::string plain;
  for (std::size_t i = 0; i < name.size(); ++i) {
    if (name.substr(i).starts_with("\u00A0")) {
      ++i;
      continue;
    }
    const char c = name[i];
    if (kBetween.find(c) == std::string_view::npos) plain += lowered(c);
  }
  return plain;
}

/// A column's name, and behind it what may be its unit.
struct NameAndUnit {
  std::string_view name, unit;
};

/// All readings of a cell of the head, the most likely one first: "Force [N]", "force, N",
/// "force/N", "force in N", "force_n".
std::vector<NameAndUnit> readings_of(std::string_view cell) {
  std::vector<NameAndUnit> readings;
  for (const std::string_view brackets : {"()", "[]", "{}", "<>"})
    if (cell.ends_with(brackets[1]))
      if (const std::size_t open = cell.rfind(brackets[0]); open != std::string_view::npos)
        readings.push_back({trimmed(cell.substr(0, open), " \t_,/-"),
                            trimmed(cell.substr(open + 1, cell.size() - open - 2), kAround)});
  if (!readings.empty()) return readings;
  const std::size_t mark = cell.find_last_of("/,_ \t");
  if (mark != std::string_view::npos && is_measurement_unit(cell.substr(mark + 1))) {
    std::string_view name = trimmed(cell.substr(0, mark), " \t_,/");
    for (const std::string_view in : {" in", "_in"})
      if (name.ends_with(in)) name.remove_suffix(in.size());
    readings.push_back({name, cell.substr(mark + 1)});
  }
  readings.push_back({cell, {}});
  return readings;
}

/// "fx" of "fx_n": the documented name without its unit.
std::string base_of(const TableColumnKind& kind) {
  const std::size_t mark = kind.key.rfind('_');
  const bool has_unit = kind.measure && mark != std::string::npos &&
                        measurement_unit(*kind.measure, kind.key.substr(mark + 1)).has_value();
  return plain_name(has_unit ? kind.key.substr(0, mark) : kind.key);
}

/// The number behind the name of a numbered kind; nullopt: another name.
std::optional<int> number_behind(std::string_view name, std::string_view base) {
  constexpr std::size_t kMaxDigits = 4;
  if (!name.starts_with(base)) return std::nullopt;
  const std::string_view digits = name.substr(base.size());
  if (digits.empty() || digits.size() > kMaxDigits ||
      !std::all_of(digits.begin(), digits.end(), is_digit))
    return std::nullopt;
  int number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// Words in brackets behind a time that are no units: "Time (UTC)".
bool is_remark_of_time(std::string_view text) {
  const std::string plain = plain_name(text);
  for (const std::string_view word :
       {"utc", "gmt", "local", "elapsed", "relative", "absolute", "hhmmss", "hmmss", "iso8601"})
    if (plain.starts_with(word)) return true;
  return false;
}

// Cells.

/// "#N/A", "#VALUE!", "#WERT!" at the front of a line: a cell, not a remark.
bool is_spreadsheet_error(std::string_view line) {
  const std::string_view cell = line.substr(0, line.find_first_of(";,\t| \r\n"));
  if (cell.size() < 3 || cell.find_first_of("abcdefghijklmnopqrstuvwxyz") != std::string_view::npos)
    return false;
  return cell.ends_with('!') || cell.ends_with('?') || cell == "#N/A" || cell == "#NV" ||
         cell == "#N/D" || cell == "#YOK";
}

/// Decimal mark of a number that can be read in one manner only: "0,5", not "1,234". 0: none.
char decimal_mark_in(std::string_view cell) {
  if (cell.starts_with('-') || cell.starts_with('+')) cell.remove_prefix(1);
  const std::size_t exponent = std::min(cell.find_first_of("eE"), cell.size());
  const std::string_view number = cell.substr(0, exponent);
  const std::size_t mark = number.find_first_of(".,");
  if (mark == std::string_view::npos || number.size() == 1) return '\0';
  const std::string_view before = number.substr(0, mark), behind = number.substr(mark + 1);
  if (!std::all_of(before.begin(), before.end(), is_digit) ||
      !std::all_of(behind.begin(), behind.end(), is_digit))
    return '\0';
  const bool may_be_thousands = behind.size() == 3 && !before.empty() && before.size() <= 3 &&
                                before[0] != '0' && exponent == cell.size();
  return may_be_thousands ? '\0' : number[mark];
}

/// As std::from_chars reads it, with the decimal mark of the table. nullopt: not in plain form.
std::optional<double> plain_value(std::string_view cell, DecimalMark mark) {
  std::array<char, 40> point;
  if (mark == DecimalMark::kComma) {
    if (cell.size() > point.size() || cell.find('.') != std::string_view::npos) return std::nullopt;
    std::replace_copy(cell.begin(), cell.end(), point.begin(), ',', '.');
    cell = {point.data(), cell.size()};
  }
  double value = 0;
  const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (status != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

/// Characters behind the decimal mark.
std::size_t digits_behind_mark(std::string_view cell) {
  const std::size_t mark = cell.find_first_of(".,");
  return mark == std::string_view::npos ? 0 : cell.size() - mark - 1;
}

/// What stands between quotes, with each doubled quote as one.
std::string undoubled(std::string_view quoted) {
  std::string plain;
  for (std::size_t i = 0; i < quoted.size(); ++i) {
    plain += quoted[i];
    if (quoted[i] == '"') ++i;
  }
  return plain;
}

bool is_open_end(std::string_view text) { return !text.empty() && !is_line_end(text.back()); }

}  // namespace

std::string table_cell(std::string_view text) {
  const bool is_plain = text.find_first_of("\",\r\n") == std::string_view::npos &&
                        !text.starts_with('#') && !text.starts_with('%');
  if (is_plain) return std::string(text);
  std::string cell = "\"";
  for (const char c : text) cell += c == '"' ? "\"\"" : std::string(1, c);
  return cell + '"';
}

std::string table_cell_text(std::string_view cell) {
  const bool is_quoted = cell.size() >= 2 && cell.front() == '"' && cell.back() == '"';
  return is_quoted ? undoubled(cell.substr(1, cell.size() - 2)) : std::string(cell);
}

Result<Table> Table::open(std::string_view bytes, const std::filesystem::path& origin,
                          TableFormat format) {
  Table table(origin, std::move(format));
  for (const TableColumnKind& kind : table.format_.kinds) table.bases_.push_back(base_of(kind));
  auto decoded = decode_text(bytes, origin);
  if (!decoded) return decoded.error();
  table.encoding_ = decoded->encoding;
  table.text_ = bytes.substr(decoded->mark_size);
  if (decoded->converted) {
    table.decoded_ = std::make_unique<std::string>(std::move(*decoded->converted));
    table.text_ = *table.decoded_;
  }
  auto head = table.find_head();
  if (!head) return head.error();
  // No byte distinguishes Chinese from Western texts, but the names of the columns do.
  if (table.encoding_ == kWesternEncoding)
    if (auto chinese = from_gb18030(bytes)) {
      auto western =
          std::exchange(table.decoded_, std::make_unique<std::string>(std::move(*chinese)));
      table.text_ = *table.decoded_;
      auto other = table.find_head();
      if (other && other->known > head->known) {
        table.encoding_ = "GB18030";
        head = std::move(other);
      } else {
        table.decoded_ = std::move(western);
        table.text_ = *table.decoded_;
        head = table.find_head();
      }
    }
  if (const Status named = table.name_columns(*head); !named) return named.error();
  if (const Status taken = table.take_units_line(); !taken) return taken.error();
  table.find_decimal_mark();
  return table;
}

Table::Line Table::read_line(Cursor& cursor, char separator) {
  cells_.clear(), unquoted_.clear();
  const std::string_view text = cursor.text;
  std::size_t i = cursor.at;
  const auto is_end = [&] { return i >= text.size() || is_line_end(text[i]); };
  const auto end_line = [&] {
    if (i < text.size()) i += text[i] == '\r' && text.substr(i + 1).starts_with('\n') ? 2 : 1;
    cursor.at = i, ++cursor.line;
  };
  const auto skip = [&](auto is_skipped) {
    while (i < text.size() && is_skipped(text[i])) ++i;
  };
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  for (;; end_line()) {
    const std::size_t begin = i;
    skip(is_blank);
    if (i >= text.size()) return cursor.at = i, Line::kEnd;
    row_line_ = cursor.line;
    if (is_end()) continue;
    const bool is_remark =
        (text[i] == '#' || text[i] == '%') && !is_spreadsheet_error(text.substr(i));
    if (!is_remark) {
      i = begin;
      break;
    }
    const std::size_t first = i;
    skip([](char c) { return !is_line_end(c); });
    cells_.push_back(text.substr(first, i - first));
    end_line();
    return Line::kRemark;
  }
  const auto is_around = [&](char c) { return c == ' ' || (c == '\t' && separator != '\t'); };
  const auto is_separator = [&] {
    if (!is_blanks(separator)) return text[i] == separator;
    return separator == kBlanks ? is_blank(text[i])
                                : text[i] == '\t' || text.substr(i).starts_with("  ");
  };
  for (;;) {
    skip(is_around);
    if (is_blanks(separator) && is_end() && !cells_.empty()) break;
    const bool is_quoted = i < text.size() && text[i] == '"';
    const std::size_t begin = is_quoted ? ++i : i;
    if (is_quoted) {
      bool is_doubled = false;
      for (; i < text.size(); ++i) {
        if (text[i] == '"' && !text.substr(i + 1).starts_with('"')) break;
        if (text[i] == '"') is_doubled = true, ++i;
        const bool is_new_line =
            text[i] == '\n' || (text[i] == '\r' && !text.substr(i + 1).starts_with('\n'));
        cursor.line += is_new_line ? 1 : 0;
      }
      if (i >= text.size()) return cursor.at = i, Line::kOpenQuote;
      std::string_view cell = text.substr(begin, i - begin);
      if (is_doubled) cell = unquoted_.emplace_back(undoubled(cell));
      cells_.push_back(trimmed(cell, " \t\r\n"));
      const std::size_t behind = ++i;
      skip(is_around);
      const bool is_followed = is_end() || (is_blanks(separator) ? i > behind : is_separator());
      if (!is_followed) {
        skip([](char c) { return !is_line_end(c); });
        return end_line(), Line::kTextBehindQuote;
      }
      if (is_blanks(separator) && !is_end()) continue;
    } else {
      while (!is_end() && !is_separator()) ++i;
      cells_.push_back(trimmed(text.substr(begin, i - begin), kAround));
    }
    if (is_end()) break;
    ++i;
  }
  end_line();
  return Line::kRow;
}

std::optional<Table::Known> Table::known(const std::string& cell) const {
  // Most cells of a file are numbers, which are no names.
  if (cell.find_first_not_of("0123456789+-.,eE") == std::string::npos) return std::nullopt;
  std::optional<Known> with_foreign_unit;
  for (const NameAndUnit& reading : readings_of(trimmed(cell, kAround))) {
    const std::string name = plain_name(reading.name);
    if (name.empty()) continue;
    for (std::size_t k = 0; k < format_.kinds.size(); ++k) {
      const TableColumnKind& kind = format_.kinds[k];
      Column column{cell, static_cast<int>(k), -1, std::nullopt};
      if (kind.measure) column.unit = measurement_unit(*kind.measure, reading.unit);
      const auto is_named = [&](std::string_view known_name) {
        if (!kind.is_numbered) return name == known_name;
        const auto number = number_behind(name, known_name);
        column.number = number.value_or(-1);
        return number.has_value();
      };
      const auto is_one_of = [&](const std::vector<std::string_view>& names) {
        return std::any_of(names.begin(), names.end(), is_named);
      };
      bool is_kind = is_named(bases_[k]) || is_one_of(kind.names) ||
                     (column.unit && is_one_of(kind.names_with_unit));
      // "Milliseconds" is a time, too; "min" may be a minimum, and "day" another column.
      const bool is_another = std::find(bases_.begin(), bases_.end(), name) != bases_.end();
      if (!is_kind && kind.measure == Measure::kTime && reading.unit.empty() && name.size() > 1 &&
          name != "min" && !is_another) {
        column.unit = measurement_unit(Measure::kTime, name);
        is_kind = column.unit.has_value();
      }
      if (!is_kind) continue;
      const bool has_foreign_unit =
          kind.measure && *kind.measure != Measure::kNumber && !column.unit &&
          !reading.unit.empty() &&
          !(kind.measure == Measure::kTime && is_remark_of_time(reading.unit));
      if (!has_foreign_unit) return Known{std::move(column), ""};
      if (!with_foreign_unit)
        with_foreign_unit = Known{std::move(column), std::string(reading.unit)};
    }
  }
  return with_foreign_unit;
}

std::optional<Table::Head> Table::head_with(char separator) {
  struct Read {
    Line kind;
    std::vector<std::string> cells;
    Cursor behind;
    int line;
  };
  std::vector<Read> lines;
  Cursor cursor = cursor_;
  while (lines.size() < kSampleLines) {
    Line kind = read_line(cursor, separator);
    if (kind == Line::kEnd) break;
    const int line = row_line_;
    if (kind == Line::kRemark) {
      // numpy and gnuplot write the names into a remark.
      Cursor inside{trimmed(cells_[0], " \t#%"), 0, line};
      if (read_line(inside, separator) != Line::kRow) cells_.clear();
    }
    std::vector<std::string> cells(cells_.begin(), cells_.end());
    // "Time (s) Force (N)" between blanks
    for (std::size_t i = 1; is_blanks(separator) && i < cells.size();) {
      const bool is_unit = cells[i].starts_with('(') || cells[i].starts_with('[');
      if (is_unit) {
        cells[i - 1] += ' ' + cells[i];
        cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(i));
      } else {
        ++i;
      }
    }
    while (cells.size() > 1 && cells.back().empty()) cells.pop_back();
    lines.push_back({kind, std::move(cells), cursor, line});
  }
  std::optional<Head> best;
  for (std::size_t i = 0; i < std::min(lines.size(), kHeadLines); ++i) {
    if (lines[i].cells.empty()) continue;
    std::set<std::pair<int, int>> kinds;
    for (const std::string& cell : lines[i].cells)
      if (const auto found = known(cell)) kinds.emplace(found->column.kind, found->column.number);
    Head head{kinds.size(),
              lines[i].kind == Line::kRemark,
              -1,
              separator,
              lines[i].cells,
              lines[i].behind,
              lines[i].line};
    std::size_t rows = 0, same = 0;
    for (std::size_t k = i + 1; k < lines.size(); ++k) {
      if (lines[k].kind == Line::kRemark) continue;
      ++rows;
      same += lines[k].cells.size() == head.cells.size() ? 1 : 0;
    }
    if (rows > 0) head.consistent = static_cast<double>(same) / static_cast<double>(rows);
    if (head.cells.size() == 1) head.consistent = -1;
    const bool is_better = !best || head.known > best->known ||
                           (head.known == best->known && best->is_remark && !head.is_remark);
    if (is_better) best = std::move(head);
  }
  return best;
}

Result<Table::Head> Table::find_head() {
  cursor_ = {text_, 0, 1};
  std::vector<char> separators(kSeparators.begin(), kSeparators.end());
  // A first line for spreadsheet programs.
  const std::string_view first =
      text_.substr(0, std::min(text_.find_first_of("\r\n"), text_.size()));
  const std::string_view rule = trimmed(first, "\"");
  if (rule.size() == 5 && rule.starts_with("sep=") &&
      std::string_view(",;:|!&/~ \t").find(rule.back()) != std::string_view::npos) {
    separators = {rule.back() == ' ' ? kBlanks : rule.back()};
    static_cast<void>(read_line(cursor_, separators.front()));
  }
  std::optional<Head> best;
  for (const char separator : separators) {
    auto head = head_with(separator);
    const auto rank = [](const Head& one) {
      return std::tuple(one.known, !one.is_remark, one.consistent);
    };
    if (head && (!best || rank(*head) > rank(*best))) best = std::move(head);
  }
  if (!best) return Error{en::say("the table is empty"), origin_, format_.advice};
  const auto is_number = [](const std::string& cell) {
    return cell.empty() || parse_typed_number(cell).ok() || resembles_time_stamp(cell);
  };
  if (best->known == 0 && std::all_of(best->cells.begin(), best->cells.end(), is_number))
    return Error{en::say("there are numbers where the names of the columns are expected"),
                 en::say("{}, line {}", origin_, best->line), format_.advice};
  separator_ = best->separator;
  cursor_ = best->behind;
  head_line_ = best->line;
  return *best;
}

Status Table::name_columns(const Head& head) {
  for (const std::string& cell : head.cells) {
    const auto found = known(cell);
    Column column = found ? found->column : Column{cell, -1, -1, std::nullopt};
    if (column.kind >= 0)
      for (const Column& other : columns_) {
        if (other.kind != column.kind || other.number != column.number) continue;
        if (other.name == column.name)
          return wrong_head(en::say("the column '{}' appears twice", printable(cell)));
        return wrong_head(en::say("the columns '{}' and '{}' both fit {}: rename one of them",
                                  printable(other.name), printable(cell), kind_of(column)->key));
      }
    columns_.push_back(std::move(column));
  }
  for (const Column& column : columns_)
    if (const auto found = known(column.name); found && !found->foreign_unit.empty())
      return wrong_head(en::say("'{}' is not a unit of the column '{}': use one of {}",
                                printable(found->foreign_unit), printable(column.name),
                                measurement_units(*kind_of(column)->measure)));
  return {};
}

Status Table::take_units_line() {
  Cursor cursor = cursor_;
  Line line = Line::kRemark;
  while (line == Line::kRemark) line = read_line(cursor, separator_);
  if (line != Line::kRow || cells_.size() > columns_.size()) return {};
  const auto unit_in = [&](std::size_t i) {
    return i < cells_.size() ? trimmed(cells_[i], " \t()[]{}<>") : std::string_view();
  };
  const auto measure_of = [&](const Column& column) {
    const TableColumnKind* kind = kind_of(column);
    return kind == nullptr ? std::nullopt : kind->measure;
  };
  bool has_unit = false;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    if (!measure_of(columns_[i])) continue;
    const std::string_view unit = unit_in(i);
    if (!unit.empty() && unit != "-" && !is_measurement_unit(unit)) return {};
    has_unit = has_unit || is_measurement_unit(unit);
  }
  if (!has_unit) return {};
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const auto measure = measure_of(columns_[i]);
    const std::string_view text = unit_in(i);
    if (!measure || text.empty() || text == "-" || *measure == Measure::kNumber) continue;
    const auto unit = measurement_unit(*measure, text);
    if (!unit)
      return wrong(en::say("'{}' is not a unit of the column '{}': use one of {}", printable(text),
                           printable(columns_[i].name), measurement_units(*measure)));
    if (columns_[i].unit && columns_[i].unit->symbol != unit->symbol)
      return wrong(en::say("the column '{}' is in {} here, in {} by its name",
                           printable(columns_[i].name), std::string(unit->symbol),
                           std::string(columns_[i].unit->symbol)));
    columns_[i].unit = unit;
  }
  cursor_ = cursor;
  return {};
}

void Table::find_decimal_mark() {
  // Between commas, only quotes protect a decimal comma.
  if (separator_ == ',' && text_.find('"') == std::string_view::npos) return;
  Cursor cursor = cursor_;
  for (Line line; (line = read_line(cursor, separator_)) != Line::kEnd;) {
    if (line != Line::kRow) continue;
    for (std::size_t i = 0; i < std::min(cells_.size(), columns_.size()); ++i) {
      const TableColumnKind* kind = kind_of(columns_[i]);
      if (kind == nullptr || !kind->measure) continue;
      const char mark = decimal_mark_in(cells_[i]);
      if (mark == '\0') continue;
      mark_ = mark == ',' ? DecimalMark::kComma : DecimalMark::kPoint;
      return;
    }
  }
}

const TableColumnKind* Table::kind_of(const Column& column) const {
  return column.kind < 0 ? nullptr : &format_.kinds[static_cast<std::size_t>(column.kind)];
}

int Table::find(std::string_view key, int number) const {
  for (std::size_t i = 0; i < columns_.size(); ++i)
    if (columns_[i].kind >= 0 && columns_[i].number == number && kind_of(columns_[i])->key == key)
      return static_cast<int>(i);
  return -1;
}

void Table::ignore(std::string_view key) {
  if (const int column = find(key); column >= 0)
    columns_[static_cast<std::size_t>(column)].kind = -1;
}

Result<bool> Table::next() {
  for (;;) {
    const Line kind = read_line(cursor_, separator_);
    if (kind == Line::kEnd) return false;
    if (kind == Line::kRemark) continue;
    if (kind == Line::kOpenQuote) return wrong(en::say("a quotation mark is not closed"));
    if (kind == Line::kTextBehindQuote)
      return wrong(en::say("there is text behind a closing quotation mark"));
    const auto is_empty = [](std::string_view cell) { return cell.empty(); };
    if (std::all_of(cells_.begin(), cells_.end(), is_empty)) continue;
    while (cells_.size() > columns_.size() && cells_.back().empty()) cells_.pop_back();
    // LabVIEW announces a last column of remarks, which its rows lack.
    if (cells_.size() + 1 == columns_.size() && columns_.back().kind < 0 &&
        plain_name(columns_.back().name).starts_with("comment"))
      cells_.emplace_back();
    const bool is_open = cursor_.at >= text_.size() && is_open_end(text_);
    const std::size_t digits = digits_behind_mark(cells_.back());
    const bool is_short = cells_.size() < columns_.size() ||
                          (row_count_ >= kRowsOfOneForm && digits < digits_behind_.value_or(0));
    if (is_open && is_short) {
      Error cut = wrong(en::say("the file ends in the middle of this line"));
      cut.advice = en::say("copying the file again, or a line end if this line is complete");
      return cut;
    }
    if (cells_.size() != columns_.size()) {
      Error error = wrong(en::say("has {} cells, not {}", cells_.size(), columns_.size()));
      if (separator_ == ',' && cells_.size() > columns_.size())
        error.advice = en::say("decimal points, or semicolons between the cells");
      return error;
    }
    if (is_open)
      remarks_.push_back(
          en::say("The last line of {} (line {}) has no line end: check that the file is complete.",
                  origin_.filename(), row_line_));
    const bool is_number = plain_value(cells_.back(), mark_).has_value();
    if (++row_count_ == 1) digits_behind_ = digits;
    if (!is_number || digits_behind_ != digits) digits_behind_.reset();
    return true;
  }
}

std::string_view Table::text(int column) const { return cells_[static_cast<std::size_t>(column)]; }

Result<double> Table::number(int column) const {
  const Column& of = columns_[static_cast<std::size_t>(column)];
  const TableColumnKind* kind = kind_of(of);
  const MeasurementUnit unit = of.unit.value_or(kind == nullptr ? MeasurementUnit() : kind->unit);
  const std::string_view cell = text(column);
  auto value = plain_value(cell, mark_);
  if (!value) {
    const auto typed = parse_typed_number(cell, {mark_, {}});
    if (!typed) return wrong(typed.error().what, column);
    const char other = mark_ == DecimalMark::kComma ? '.' : ',';
    if (cell.find(other) != std::string_view::npos)
      return wrong(en::say("'{}' has another decimal mark than the other numbers", printable(cell)),
                   column);
    value = *typed;
  }
  const double converted = unit.convert(*value);
  if (!std::isfinite(converted))
    return wrong(en::say("'{}' is too large or too small a number", printable(cell)), column);
  return converted;
}

Result<std::string> Table::digits(int column) const {
  if (const auto value = number(column); !value) return value.error();
  std::string digits(text(column));
  if (mark_ == DecimalMark::kComma) std::replace(digits.begin(), digits.end(), ',', '.');
  return plain_value(digits, DecimalMark::kPoint) ? digits
                                                  : plain_number(text(column), {mark_, {}});
}

Result<double> Table::time_s(int column, int date) {
  Column& of = columns_[static_cast<std::size_t>(column)];
  const std::string_view cell = text(column);
  const bool is_first = !time_.is_known;
  const bool is_stamp = resembles_time_stamp(cell);
  if (is_first) time_.is_known = true, time_.is_stamp = is_stamp;
  if (time_.is_stamp != is_stamp) return other_time_form(column);
  if (is_stamp) return stamp_s(column, date, is_first);
  auto value = number(column);
  if (!value || of.unit || !is_first) return value;
  // Nothing else has such numbers: in s, 1e11 is in the year 5138.
  using Scale = std::pair<double, const char*>;
  for (const auto& [from, name] : {Scale{1e17, "ns"}, Scale{1e14, "us"}, Scale{1e11, "ms"}})
    if (*value >= from) {
      of.unit = measurement_unit(Measure::kTime, name);
      time_.is_since_1970 = true;
      return number(column);
    }
  return value;
}

Result<std::int64_t> Table::time_ns(int column) const {
  const std::string_view cell = text(column);
  const MeasurementUnit unit =
      columns_[static_cast<std::size_t>(column)].unit.value_or(MeasurementUnit{1, 1e9, "ns"});
  if (unit.symbol == "ns") {
    std::int64_t ns = 0;
    const auto [end, status] = std::from_chars(cell.data(), cell.data() + cell.size(), ns);
    if (status == std::errc{} && end == cell.data() + cell.size()) return ns;
    return wrong(en::say("'{}' is not an integer in ns: name the column by its unit, as t_ms",
                         printable(cell)),
                 column);
  }
  const auto seconds = number(column);
  if (!seconds) return seconds.error();
  constexpr double kMaxSeconds = 9e9;
  if (std::abs(*seconds) > kMaxSeconds)
    return wrong(en::say("'{}' is too large or too small a number", printable(cell)), column);
  return std::llround(1e9 * *seconds);
}

Result<double> Table::stamp_s(int column, int date, bool is_first) {
  const auto read = [&](int of) -> Result<TimeStamp> {
    auto stamp = parse_time_stamp(text(of));
    if (!stamp) return wrong(stamp.error().what, of);
    return stamp;
  };
  auto stamp = read(column);
  if (!stamp) return stamp.error();
  std::string_view day = text(column);
  if (date >= 0 && !stamp->date) {
    const auto other = read(date);
    if (!other) return other.error();
    stamp->date = other->date, stamp->is_date_ambiguous = other->is_date_ambiguous;
    day = text(date);
  }
  day = day.substr(0, day.find(' '));
  const bool has_date = stamp->date.has_value(), has_zone = stamp->ahead_of_s.has_value();
  if (is_first) time_.has_date = has_date, time_.has_zone = has_zone, time_.first_day = day;
  if (time_.has_date != has_date || time_.has_zone != has_zone) return other_time_form(column);
  // Differences of times are the same in either order of day and month while the date is one.
  if (stamp->is_date_ambiguous && day != time_.first_day)
    return wrong(en::say("'{}' can have the day or the month first: write the year first, as in "
                         "2026-12-31",
                         printable(day)),
                 column);
  return stamp->seconds();
}

Error Table::other_time_form(int column) const {
  return wrong(
      en::say("'{}' is a time of another form than those before it", printable(text(column))),
      column);
}

Error Table::wrong_head(Message what) const {
  return {std::move(what), en::say("{}, line {}", origin_, head_line_), format_.advice};
}

Error Table::wrong(Message what, int column) const {
  const Message line = en::say("{}, line {}", origin_, row_line_);
  const Message advice = format_.row_advice.empty()
                             ? en::say("removing the line, or entering what was measured")
                             : format_.row_advice;
  if (column < 0) return {std::move(what), line, advice};
  const std::string name = printable(columns_[static_cast<std::size_t>(column)].name);
  return {std::move(what), en::say("{}, column {}", line, name), advice};
}

Error Table::missing(const std::string& key) const {
  std::string found;
  for (std::size_t i = 0; i < std::min(columns_.size(), kListedNames); ++i)
    found += fmt::format("{}'{}'", i == 0 ? "" : ", ", printable(columns_[i].name));
  if (columns_.size() > kListedNames) found += ", ...";
  return wrong_head(en::say("the column '{}' is missing; found: {}", key, found));
}

Message Table::understood() const {
  const auto separated = [&] {
    if (separator_ == ';') return en::say("semicolon-separated");
    if (separator_ == '\t') return en::say("tab-separated");
    if (separator_ == ',') return en::say("comma-separated");
    return is_blanks(separator_) ? en::say("blank-separated")
                                 : en::say("separated by '{}'", std::string(1, separator_));
  };
  Message form = separated();
  if (mark_ == DecimalMark::kComma) form = en::say("{} with decimal commas", form);
  if (!encoding_.empty()) form = en::say("{} {}", encoding_, form);
  std::vector<Message> parts;
  for (const Column& column : columns_) {
    if (column.kind < 0 || column.number >= 0) continue;
    const TableColumnKind& kind = *kind_of(column);
    const std::string name = printable(column.name);
    const bool is_time = kind.measure == Measure::kTime;
    if (is_time && time_.is_stamp) {
      parts.push_back(en::say("{} from the time stamps of '{}'", kind.key, name));
    } else if (is_time && time_.is_since_1970) {
      parts.push_back(en::say("{} from '{}' in {} since 1970", kind.key, name,
                              std::string(column.unit->symbol)));
    } else if (column.name == kind.key) {
      parts.push_back(Message::typed(kind.key));
    } else if (column.unit) {
      parts.push_back(
          en::say("{} from '{}' in {}", kind.key, name, std::string(column.unit->symbol)));
    } else {
      parts.push_back(en::say("{} from '{}'", kind.key, name));
    }
  }
  const Message columns = en::list(parts);
  return en::say("Read {} as {}: {}.", origin_, form, columns);
}

}  // namespace alltact
