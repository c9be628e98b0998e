#include "calibration/force/force_table.h"

#include "core/base/atomic_file.h"
#include "core/base/message.h"
#include "core/base/table.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>

#include <fmt/format.h>

namespace alltact {
namespace {

constexpr int kMaxTableMarkers = 512;
constexpr double kFarthestPx = 1e5, kFarthestMm = 1e4, kGreatestN = 1e5, kGreatestS = 1e12;

Message table_advice() {
  return en::say(
      "a table whose head names u0, v0, ..., fx_n, fy_n; alltact force --collect makes one");
}

TableFormat force_format() {
  return {{{.key = "u_px", .measure = Measure::kPixel, .names = {"x"}, .is_numbered = true},
           {.key = "v_px", .measure = Measure::kPixel, .names = {"y"}, .is_numbered = true},
           {.key = "seen", .measure = Measure::kNumber, .is_numbered = true},
           {"fx_n", Measure::kForce},
           {"fy_n", Measure::kForce},
           {"fz_n", Measure::kForce},
           {"along_mm", Measure::kLength},
           {"across_mm", Measure::kLength},
           {"t_s", Measure::kTime, {"time"}},
           {"block"},
           {"day"},
           {"indenter"},
           {"frame"}},
          table_advice()};
}

class ForceTableReader {
 public:
  ForceTableReader(Table table, std::filesystem::path origin)
      : rows_(std::move(table)), origin_(std::move(origin)) {}

  Result<ForceTable> read() {
    if (const Status head = read_head(); !head) return head.error();
    for (auto more = rows_.next();; more = rows_.next()) {
      if (!more) return more.error();
      if (!*more) break;
      if (const Status row = read_row(); !row) return row.error();
    }
    return finish();
  }

 private:
  Status read_head() {
    int highest = -1;
    for (const Table::Column& column : rows_.columns()) {
      highest = std::max(highest, column.number);
      if (column.kind < 0 && !column.name.empty())
        table_.ignored_columns.push_back(printable(column.name));
    }
    if (highest < 0)
      return rows_.wrong_head(en::say("there are no columns u0, v0, ... of markers"));
    if (highest >= kMaxTableMarkers)
      return rows_.wrong_head(en::say("there are markers up to number {}; the highest may be {}",
                                      highest, kMaxTableMarkers - 1));
    for (int m = 0; m <= highest; ++m) {
      u_.push_back(rows_.find("u_px", m)), v_.push_back(rows_.find("v_px", m));
      seen_.push_back(rows_.find("seen", m));
      if (u_.back() < 0 || v_.back() < 0)
        return rows_.wrong_head(en::say("the column '{}' is missing, though there is a marker {}",
                                        fmt::format("{}{}", u_.back() < 0 ? 'u' : 'v', m),
                                        highest));
    }
    const auto unmarked = std::find(seen_.begin(), seen_.end(), -1);
    if (unmarked != seen_.end() && seen_ != std::vector<int>(seen_.size(), -1))
      return rows_.wrong_head(en::say("the column '{}' is missing, though other markers have one",
                                      fmt::format("seen{}", unmarked - seen_.begin())));
    for (const char* axis : {"fx_n", "fy_n", "fz_n"}) {
      const int column = rows_.find(axis);
      if (column < 0 && force_.size() < 2) return rows_.missing(axis);
      if (column >= 0) force_.push_back(column);
    }
    along_ = rows_.find("along_mm"), across_ = rows_.find("across_mm");
    if ((along_ < 0) != (across_ < 0))
      return rows_.wrong_head(
          en::say("the contact position has only one of along_mm and across_mm"));
    time_ = rows_.find("t_s");
    return {};
  }

  Result<double> number(int column, double greatest) const {
    const auto value = rows_.number(column);
    if (value && std::abs(*value) > greatest) return beyond_range(column);
    return value;
  }
  [[nodiscard]] Error beyond_range(int column) const {
    return rows_.wrong(
        en::say("'{}' is beyond the measurable range", printable(rows_.text(column))), column);
  }

  Status read_row() {
    if (Status status = read_markers(); !status) return status;
    for (const int column : force_) {
      const auto force = number(column, kGreatestN);
      if (!force) return force.error();
      force_N_.push_back(*force);
    }
    if (time_ >= 0) {
      const auto time = rows_.time_s(time_);
      if (!time) return time.error();
      if (std::abs(*time) > kGreatestS) return beyond_range(time_);
      time_s_.push_back(*time);
    }
    if (Status status = read_position(); !status) return status;
    for (auto [key, list] : {std::pair{"block", &table_.block},
                             {"day", &table_.day},
                             {"indenter", &table_.indenter},
                             {"frame", &table_.frame}})
      if (const int column = rows_.find(key); column >= 0) list->emplace_back(rows_.text(column));
    ++count_;
    return {};
  }

  Status read_markers() {
    bool any = false;
    for (std::size_t m = 0; m < u_.size(); ++m) {
      bool seen = !rows_.text(u_[m]).empty() || !rows_.text(v_[m]).empty();
      if (seen_[m] >= 0) {
        const auto flag = rows_.number(seen_[m]);
        if (!flag) return flag.error();
        if (*flag != 0 && *flag != 1)
          return rows_.wrong(en::say("'{}' is neither 1 nor 0", printable(rows_.text(seen_[m]))),
                             seen_[m]);
        seen = *flag == 1;
      }
      for (const int column : {u_[m], v_[m]}) {
        const auto position = seen ? number(column, kFarthestPx) : Result<double>(0.0);
        if (!position) return position.error();
        layouts_.push_back(*position);
      }
      any = any || seen;
      is_seen_.push_back(seen ? 1 : 0);
    }
    return any ? Status() : rows_.wrong(en::say("no marker was seen"));
  }

  Status read_position() {
    if (along_ < 0) return {};
    const bool known = !rows_.text(along_).empty() || !rows_.text(across_).empty();
    for (const int column : {along_, across_}) {
      const auto position = known ? number(column, kFarthestMm)
                                  : Result<double>(std::numeric_limits<double>::quiet_NaN());
      if (!position) return position.error();
      position_mm_.push_back(*position);
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
    table_.marker_count = static_cast<int>(u_.size());
    table_.axes = static_cast<int>(force_.size());
    table_.layouts = matrix(layouts_), table_.seen = matrix(is_seen_);
    table_.force_N = matrix(force_N_);
    if (!position_mm_.empty() && matrix(position_mm_).array().isFinite().any())
      table_.position_mm = matrix(position_mm_);
    if (!time_s_.empty()) table_.time_s = matrix(time_s_);
    table_.understood.push_back(rows_.understood());
    table_.remarks = rows_.remarks();
    return std::move(table_);
  }

  Table rows_;
  std::filesystem::path origin_;
  std::vector<int> u_, v_, seen_, force_;  // columns
  int along_ = -1, across_ = -1, time_ = -1;
  std::vector<double> layouts_, is_seen_, force_N_, position_mm_, time_s_;  // row by row
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
  auto table = Table::open(csv, origin, force_format());
  if (!table) return table.error();
  return ForceTableReader(std::move(*table), origin).read();
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
      if (!list->empty()) cell(table_cell((*list)[i]));
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
  joined.understood.insert(joined.understood.end(), part.understood.begin(), part.understood.end());
  joined.remarks.insert(joined.remarks.end(), part.remarks.begin(), part.remarks.end());
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
