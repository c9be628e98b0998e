// Joins force tables.
#include "calibration/force/force_split.h"
#include "calibration/force/force_table.h"
#include "core/io/atomic_file.h"
#include "core/message.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

namespace alltact {
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
                           part->marker_count,
                           part->axes,
                           joined->marker_count,
                           joined->axes),
                   file,
                   en::say("tables of one finger and one kind of gauge")};
    append_table(*part, *joined);
  }
  if (Status status = joined->check(files.front()); !status) return status.error();
  return *joined;
}

}  // namespace alltact
