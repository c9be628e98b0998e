#include "calibration/force/force_table.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <charconv>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kMaxTableMarkers = 512;
constexpr double kFarthestPx = 1e5, kGreatestN = 1e5;

Message table_advice() {
  return en::say(
      "a CSV whose first line names u0, v0, ..., fx_n, fy_n; alltact force --collect makes one");
}

/// Indices of a table's columns; -1: missing.
struct TableColumns {
  std::vector<int> u, v, seen;
  std::vector<int> force;
  int along = -1, across = -1, time = -1, block = -1, day = -1, indenter = -1, frame = -1;
  std::size_t count = 0;
  std::vector<std::string> ignored_columns;
};

/// Parses "u07" as 'u' and 7.
std::optional<std::pair<std::string, int>> numbered(const std::string& name) {
  const std::size_t digits = name.find_first_of("0123456789");
  if (digits == std::string::npos || digits == 0 || name.size() - digits > 4) return std::nullopt;
  int number = 0;
  const auto [end, status] =
      std::from_chars(name.data() + digits, name.data() + name.size(), number);
  if (status != std::errc{} || end != name.data() + name.size()) return std::nullopt;
  const std::string letters = name.substr(0, digits);
  if (letters == "u" || letters == "x") return std::pair{std::string("u"), number};
  if (letters == "v" || letters == "y") return std::pair{std::string("v"), number};
  if (letters == "seen") return std::pair{letters, number};
  return std::nullopt;
}

Result<TableColumns> columns_of(const std::vector<std::string_view>& cells,
                                const std::filesystem::path& origin) {
  const auto wrong = [&](Message what) {
    return Error{std::move(what), en::say("{}, line 1", origin), table_advice()};
  };
  std::map<std::string, int> plain, by_number;
  TableColumns columns;
  columns.count = cells.size();
  int highest = -1;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    std::string name = csv_column(cells[i]);
    const auto marker = numbered(name);
    if (marker) {
      highest = std::max(highest, marker->second);
      name = fmt::format("{}{}", marker->first, marker->second);
    }
    if (!name.empty() && !(marker ? by_number : plain).emplace(name, static_cast<int>(i)).second)
      return wrong(en::say("the column '{}' appears twice", printable(cells[i])));
  }
  if (highest < 0) return wrong(en::say("there are no columns u0, v0, ... of markers"));
  if (highest >= kMaxTableMarkers)
    return wrong(en::say("there are markers up to number {}; the highest may be {}", highest,
                         kMaxTableMarkers - 1));
  const auto take = [](std::map<std::string, int>& from, const std::string& name) {
    const auto found = from.find(name);
    if (found == from.end()) return -1;
    const int at = found->second;
    from.erase(found);
    return at;
  };
  bool some_seen = false;
  for (int m = 0; m <= highest; ++m) {
    for (auto [letter, list] : {std::pair{"u", &columns.u}, {"v", &columns.v}}) {
      list->push_back(take(by_number, fmt::format("{}{}", letter, m)));
      if (list->back() < 0)
        return wrong(en::say("the column '{}' is missing, though there is a marker {}",
                             fmt::format("{}{}", letter, m), highest));
    }
    columns.seen.push_back(take(by_number, fmt::format("seen{}", m)));
    some_seen = some_seen || columns.seen.back() >= 0;
  }
  for (int m = 0; some_seen && m <= highest; ++m)
    if (columns.seen[static_cast<std::size_t>(m)] < 0)
      return wrong(en::say("the column '{}' is missing, though other markers have one",
                           fmt::format("seen{}", m)));
  for (const char* axis : {"fx", "fy", "fz"}) {
    const int at = take(plain, axis);
    if (at < 0 && columns.force.size() < 2)
      return wrong(en::say("the column '{}' is missing", fmt::format("{}_n", axis)));
    if (at >= 0) columns.force.push_back(at);
  }
  columns.along = take(plain, "along"), columns.across = take(plain, "across");
  if ((columns.along < 0) != (columns.across < 0))
    return wrong(en::say("the contact position has only one of along_mm and across_mm"));
  columns.time = take(plain, "t");
  if (columns.time < 0) columns.time = take(plain, "time");
  columns.block = take(plain, "block"), columns.day = take(plain, "day");
  columns.indenter = take(plain, "indenter"), columns.frame = take(plain, "frame");
  for (const auto& [name, at] : plain) columns.ignored_columns.push_back(printable(name));
  return columns;
}

class TableReader {
 public:
  TableReader(std::string_view csv, const std::filesystem::path& origin)
      : lines_(csv), origin_(origin) {}

  Result<ForceTable> read() {
    const auto first = lines_.next();
    if (!first) return Error{en::say("the table is empty"), origin_, table_advice()};
    auto columns = columns_of(lines_.cells(*first), origin_);
    if (!columns) return columns.error();
    columns_ = std::move(*columns);
    while (const auto line = lines_.next())
      if (Status status = read_row(lines_.cells(*line)); !status) return status.error();
    return finish();
  }

 private:
  [[nodiscard]] Error wrong(Message what, std::string_view column = {}) const {
    const Message line = en::say("{}, line {}", origin_, lines_.number());
    return {std::move(what),
            column.empty() ? line : en::say("{}, column {}", line, printable(column)),
            en::say("removing the line, or entering what was measured")};
  }

  Result<double> number(const std::vector<std::string_view>& cells, int at, std::string_view column,
                        double greatest) const {
    const std::string_view cell = cells[static_cast<std::size_t>(at)];
    const auto value = lines_.number_in(cell);
    if (!value) return wrong(en::say("'{}' is not a number", printable(cell)), column);
    if (std::abs(*value) > greatest)
      return wrong(en::say("'{}' is beyond the measurable range", printable(cell)), column);
    return *value;
  }

  Status read_row(const std::vector<std::string_view>& cells) {
    if (cells.size() != columns_.count)
      return wrong(en::say("has {} cells, not {}", cells.size(), columns_.count));
    if (Status status = read_markers(cells); !status) return status;
    static constexpr std::array<const char*, 3> kAxes{"fx_n", "fy_n", "fz_n"};
    for (std::size_t axis = 0; axis < columns_.force.size(); ++axis) {
      const auto force = number(cells, columns_.force[axis], kAxes[axis], kGreatestN);
      if (!force) return force.error();
      force_.push_back(*force);
    }
    if (columns_.time >= 0) {
      const auto time = number(cells, columns_.time, "t_s", 1e12);
      if (!time) return time.error();
      time_.push_back(*time);
    }
    if (Status status = read_position(cells); !status) return status;
    for (auto [at, list] : {std::pair{columns_.block, &table_.block},
                            {columns_.day, &table_.day},
                            {columns_.indenter, &table_.indenter},
                            {columns_.frame, &table_.frame}})
      if (at >= 0) list->emplace_back(cells[static_cast<std::size_t>(at)]);
    ++count_;
    return {};
  }

  Status read_markers(const std::vector<std::string_view>& cells) {
    bool any = false;
    for (std::size_t m = 0; m < columns_.u.size(); ++m) {
      const std::string name = fmt::format("u{}", m);
      const auto u_cell = cells[static_cast<std::size_t>(columns_.u[m])];
      const auto v_cell = cells[static_cast<std::size_t>(columns_.v[m])];
      bool seen = !u_cell.empty() || !v_cell.empty();
      if (columns_.seen[m] >= 0) {
        const auto flag = number(cells, columns_.seen[m], fmt::format("seen{}", m), 1);
        if (!flag) return flag.error();
        if (*flag != 0 && *flag != 1) return wrong(en::say("seen must be 1 or 0"), name);
        seen = *flag == 1;
      }
      double u = 0, v = 0;
      if (seen) {
        const auto there_u = number(cells, columns_.u[m], name, kFarthestPx);
        if (!there_u) return there_u.error();
        const auto there_v = number(cells, columns_.v[m], fmt::format("v{}", m), kFarthestPx);
        if (!there_v) return there_v.error();
        u = *there_u, v = *there_v;
      }
      any = any || seen;
      layouts_.push_back(u), layouts_.push_back(v);
      seen_.push_back(seen ? 1 : 0);
    }
    return any ? Status() : wrong(en::say("no marker was seen"));
  }

  Status read_position(const std::vector<std::string_view>& cells) {
    if (columns_.along < 0) return {};
    const bool known = !cells[static_cast<std::size_t>(columns_.along)].empty() ||
                       !cells[static_cast<std::size_t>(columns_.across)].empty();
    for (auto [at, name] :
         {std::pair{columns_.along, "along_mm"}, {columns_.across, "across_mm"}}) {
      double position = std::numeric_limits<double>::quiet_NaN();
      if (known) {
        const auto there = number(cells, at, name, 1e4);
        if (!there) return there.error();
        position = *there;
      }
      position_.push_back(position);
    }
    return {};
  }

  Result<ForceTable> finish() {
    if (count_ == 0)
      return Error{en::say("{} rows are too few to train with", 0), origin_, table_advice()};
    using ByRow = Eigen::Matrix<double, -1, -1, Eigen::RowMajor>;
    const auto matrix = [&](const std::vector<double>& numbers) -> Eigen::MatrixXd {
      return Eigen::Map<const ByRow>(numbers.data(), count_,
                                     static_cast<Eigen::Index>(numbers.size()) / count_);
    };
    table_.marker_count = static_cast<int>(columns_.u.size());
    table_.axes = static_cast<int>(columns_.force.size());
    table_.layouts = matrix(layouts_), table_.seen = matrix(seen_);
    table_.force_N = matrix(force_);
    if (!position_.empty() && matrix(position_).array().isFinite().any())
      table_.position_mm = matrix(position_);
    if (!time_.empty()) table_.time_s = matrix(time_);
    table_.ignored_columns = columns_.ignored_columns;
    return std::move(table_);
  }

  CsvLines lines_;
  std::filesystem::path origin_;
  TableColumns columns_;
  std::vector<double> layouts_, seen_, force_, position_, time_;  // checked cells, row by row
  ForceTable table_;
  Eigen::Index count_ = 0;
};

bool something_moves(const ForceTable& table) {
  for (Eigen::Index c = 0; c < table.layouts.cols(); ++c) {
    double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
    for (Eigen::Index row = 0; row < table.rows(); ++row)
      if (table.seen(row, c / 2) > 0.5) {
        lowest = std::min(lowest, table.layouts(row, c));
        highest = std::max(highest, table.layouts(row, c));
      }
    if (highest - lowest > 1e-6) return true;
  }
  return false;
}

}  // namespace

std::string csv_column(std::string_view name) {
  std::string column;
  for (const char c : name) column += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  for (const char* unit : {"_px", "_mm", "_n", "_s"})
    if (column.ends_with(unit)) {
      column.resize(column.size() - std::string_view(unit).size());
      break;
    }
  return column;
}

Status ForceTable::check(const std::filesystem::path& origin) {
  const auto too_bad = [&](Message what, Message advice) {
    return Error{std::move(what), origin, std::move(advice)};
  };
  if (rows() < static_cast<Eigen::Index>(kMinRows))
    return too_bad(en::say("{} rows are too few to train with", rows()),
                   en::say("at least {}, better several hundred", kMinRows));
  if (axes == 3 && (force_N.col(2).array() == 0).all()) {
    force_N.conservativeResize(Eigen::NoChange, 2);
    axes = 2;
    ignored_columns.emplace_back("fz_n");
  }
  static constexpr std::array<const char*, 3> kAxes{"fx_n", "fy_n", "fz_n"};
  for (int axis = 0; axis < axes; ++axis) {
    const auto column = force_N.col(axis).array();
    if (column.maxCoeff() - column.minCoeff() < 1e-9)
      return too_bad(
          en::say("the force '{}' is the same in all rows",
                  std::string(kAxes[static_cast<std::size_t>(axis)])),
          axis < 2 ? en::say("pressing in different directions; several tables may be given")
                   : en::say("pressing with different forces, or leaving the column fz_n out"));
  }
  if (!something_moves(*this))
    return too_bad(en::say("no marker ever moves"), en::say("a table of this recording's markers"));
  return {};
}

Result<ForceTable> ForceTable::parse_part(std::string_view csv,
                                          const std::filesystem::path& origin) {
  return TableReader(csv, origin).read();
}

Result<ForceTable> ForceTable::parse(std::string_view csv, const std::filesystem::path& origin) {
  auto table = parse_part(csv, origin);
  if (!table) return table;
  if (Status status = table->check(origin); !status) return status.error();
  return table;
}

Result<ForceTable> ForceTable::load(const std::filesystem::path& file) {
  const auto content = read_file(file, kMaxBytes);
  if (!content) return content.error();
  return parse(*content, file);
}

std::string ForceTable::to_csv() const {
  std::string text;
  const auto add = [&](std::string_view cell) {
    if (!text.empty() && text.back() != '\n') text += ',';
    text += cell;
  };
  const std::array<std::pair<const char*, const std::vector<std::string>*>, 4> names{
      {{"frame", &frame}, {"block", &block}, {"day", &day}, {"indenter", &indenter}}};
  for (const auto& [name, list] : names)
    if (!list->empty()) add(name);
  if (time_s.size() > 0) add("t_s");
  add(axes == 3 ? "fx_n,fy_n,fz_n" : "fx_n,fy_n");
  if (has_position()) add("along_mm,across_mm");
  for (int m = 0; m < marker_count; ++m) add(fmt::format("u{0},v{0},seen{0}", m));
  text += '\n';
  for (Eigen::Index row = 0; row < rows(); ++row) {
    const auto i = static_cast<std::size_t>(row);
    // An empty first cell is a cell, too.
    bool is_first = true;
    const auto cell = [&](std::string_view value) {
      if (!is_first) text += ',';
      is_first = false;
      text += value;
    };
    for (const auto& [name, list] : names)
      if (!list->empty()) cell((*list)[i]);
    if (time_s.size() > 0) cell(fmt::format("{}", time_s[row]));
    for (int axis = 0; axis < axes; ++axis) cell(fmt::format("{}", force_N(row, axis)));
    for (Eigen::Index k = 0; has_position() && k < 2; ++k)
      cell(std::isfinite(position_mm(row, k)) ? fmt::format("{}", position_mm(row, k)) : "");
    for (int m = 0; m < marker_count; ++m) {
      const bool is_seen = seen(row, m) > 0.5;
      for (int k = 0; k < 2; ++k)
        cell(is_seen ? fmt::format("{}", layouts(row, 2 * m + k)) : std::string());
      cell(is_seen ? "1" : "0");
    }
    text += '\n';
  }
  return text;
}

namespace {

std::vector<Eigen::Index> rows_where(const std::vector<int>& of, int fold, bool is_in) {
  std::vector<Eigen::Index> rows;
  for (std::size_t i = 0; i < of.size(); ++i)
    if ((of[i] == fold) == is_in) rows.push_back(static_cast<Eigen::Index>(i));
  return rows;
}

ForceFolds folds_by_name(const std::vector<std::string>& names) {
  std::map<std::string, int> groups;  // in order of first occurrence
  ForceFolds folds;
  for (const std::string& name : names)
    folds.of.push_back(groups.emplace(name, static_cast<int>(groups.size())).first->second);
  folds.count = std::min(kMaxFolds, static_cast<int>(groups.size()));
  for (int& fold : folds.of) fold %= folds.count;
  return folds;
}

ForceFolds folds_of_stretches(const ForceTable& table) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(table.rows()));
  std::iota(order.begin(), order.end(), 0);
  if (table.time_s.size() > 0)
    std::stable_sort(order.begin(), order.end(), [&](Eigen::Index a, Eigen::Index b) {
      return table.time_s[a] < table.time_s[b];
    });
  ForceFolds folds;
  folds.count = kStretches;
  folds.by_time = true;
  folds.of.resize(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    folds.of[static_cast<std::size_t>(order[i])] = static_cast<int>(i * kStretches / order.size());
  return folds;
}

}  // namespace

std::vector<Eigen::Index> ForceFolds::rows_in(int fold) const { return rows_where(of, fold, true); }
std::vector<Eigen::Index> ForceFolds::rows_without(int fold) const {
  return rows_where(of, fold, false);
}

std::vector<Eigen::Index> drawn_order(Eigen::Index n, std::uint64_t seed, std::string_view who,
                                      std::uint32_t which) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    const double drawn = philox_uniform(seed, who, which, static_cast<std::uint32_t>(i));
    std::swap(order[i - 1],
              order[std::min(i - 1, static_cast<std::size_t>(drawn * static_cast<double>(i)))]);
  }
  return order;
}

Result<ForceFolds> force_folds(const ForceTable& table, ForceSplit split, std::uint64_t seed) {
  if (split == ForceSplit::kRandom) {
    ForceFolds folds;
    folds.count = table.rows() < 500 ? kStretches : kMaxFolds;
    folds.of.resize(static_cast<std::size_t>(table.rows()));
    const auto order = drawn_order(table.rows(), seed, "force random split");
    for (std::size_t i = 0; i < order.size(); ++i)
      folds.of[static_cast<std::size_t>(order[i])] = static_cast<int>(i) % folds.count;
    return folds;
  }
  if (split == ForceSplit::kBlock) {
    ForceFolds folds = folds_by_name(table.block);
    return folds.count > 1 ? folds : folds_of_stretches(table);
  }
  const bool by_day = split == ForceSplit::kDay;
  ForceFolds folds = folds_by_name(by_day ? table.day : table.indenter);
  if (folds.count > 1) return folds;
  const std::string column(by_day ? "day" : "indenter");
  return Error{folds.count == 0 ? en::say("the table has no column '{}'", column)
                                : en::say("the column '{}' is the same in all rows", column),
               std::string("--split"), en::say("--split block, or several values")};
}

// Joins force tables.

namespace {

using Names = std::vector<std::string>;

/// Appends names; a part without names is empty where another has them.
void append_names(const Names& part, std::size_t rows, std::size_t before, Names& joined) {
  if (part.empty() && joined.empty()) return;
  joined.resize(before);
  joined.insert(joined.end(), part.begin(), part.end());
  joined.resize(before + rows);
}

void append_rows(const Eigen::MatrixXd& part, Eigen::MatrixXd& joined) {
  const Eigen::Index before = joined.rows();
  joined.conservativeResize(before + part.rows(), part.cols());
  joined.bottomRows(part.rows()) = part;
}

Eigen::MatrixXd positions_of(const ForceTable& table) {
  if (table.has_position()) return table.position_mm;
  return Eigen::MatrixXd::Constant(table.rows(), 2, std::numeric_limits<double>::quiet_NaN());
}

/// Distinguishes blocks of the same name in two recordings. Where a table has none, stretches of
/// its rows are blocks.
void name_blocks_after(const std::string& file, ForceTable& table) {
  for (std::string& block : table.block) block = fmt::format("{} {}", file, block);
  if (!table.block.empty()) return;
  const auto rows = static_cast<std::size_t>(table.rows());
  for (std::size_t row = 0; row < rows; ++row)
    table.block.push_back(fmt::format("{} {}", file, row * kStretches / rows));
}

void append_table(const ForceTable& part, ForceTable& joined) {
  const auto before = static_cast<std::size_t>(joined.rows());
  const auto rows = static_cast<std::size_t>(part.rows());
  Eigen::MatrixXd positions = positions_of(joined);
  append_rows(positions_of(part), positions);
  if (part.has_position() || joined.has_position()) joined.position_mm = std::move(positions);
  append_rows(part.layouts, joined.layouts);
  append_rows(part.seen, joined.seen);
  if (part.time_s.size() > 0 && joined.time_s.size() > 0) {
    Eigen::VectorXd times(joined.time_s.size() + part.time_s.size());
    times << joined.time_s, part.time_s;
    joined.time_s = std::move(times);
  } else {
    joined.time_s.resize(0);
  }
  append_rows(part.force_N, joined.force_N);
  append_names(part.block, rows, before, joined.block);
  append_names(part.day, rows, before, joined.day);
  append_names(part.indenter, rows, before, joined.indenter);
  append_names(part.frame, rows, before, joined.frame);
  for (const std::string& name : part.ignored_columns)
    if (std::find(joined.ignored_columns.begin(), joined.ignored_columns.end(), name) ==
        joined.ignored_columns.end())
      joined.ignored_columns.push_back(name);
}

Result<ForceTable> load_part(const std::filesystem::path& file) {
  const auto content = read_file(file, ForceTable::kMaxBytes);
  if (!content) return content.error();
  return ForceTable::parse_part(*content, file);
}

}  // namespace

Result<ForceTable> ForceTable::load_all(const std::vector<std::filesystem::path>& files) {
  if (files.size() == 1) return load(files.front());
  std::optional<ForceTable> joined;
  for (const std::filesystem::path& file : files) {
    auto part = load_part(file);
    if (!part) return part.error();
    const std::string name = file.stem().string();
    name_blocks_after(name, *part);
    if (!joined) {
      joined = std::move(*part);
      continue;
    }
    if (part->marker_count != joined->marker_count || part->axes != joined->axes)
      return Error{en::say("has {} markers and {} axes, the tables before it {} and {}",
                           part->marker_count, part->axes, joined->marker_count, joined->axes),
                   file, en::say("tables of one finger and one kind of gauge")};
    append_table(*part, *joined);
  }
  if (Status status = joined->check(files.front()); !status) return status.error();
  return *joined;
}

}  // namespace alltact
