// Several force tables as one.
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

/// One below the other; a part that has none is empty where another has them.
void append_names(const Names& part, std::size_t rows, std::size_t before, Names& whole) {
  if (part.empty() && whole.empty()) return;
  whole.resize(before);
  whole.insert(whole.end(), part.begin(), part.end());
  whole.resize(before + rows);
}

void append_rows(const Eigen::MatrixXd& part, Eigen::MatrixXd& whole) {
  const Eigen::Index before = whole.rows();
  whole.conservativeResize(before + part.rows(), part.cols());
  whole.bottomRows(part.rows()) = part;
}

Eigen::MatrixXd places_of(const ForceTable& table) {
  if (table.has_place()) return table.place_mm;
  return Eigen::MatrixXd::Constant(table.rows(), 2, std::numeric_limits<double>::quiet_NaN());
}

/// Rows of two recordings that call a press the same were not pressed in one go. Where a table
/// names none, stretches of its rows stand for them.
void name_blocks_after(const std::string& file, ForceTable& table) {
  for (std::string& block : table.block) block = fmt::format("{} {}", file, block);
  if (!table.block.empty()) return;
  const auto rows = static_cast<std::size_t>(table.rows());
  for (std::size_t row = 0; row < rows; ++row)
    table.block.push_back(fmt::format("{} {}", file, row * kStretches / rows));
}

void append_table(const ForceTable& part, ForceTable& whole) {
  const auto before = static_cast<std::size_t>(whole.rows());
  const auto rows = static_cast<std::size_t>(part.rows());
  Eigen::MatrixXd places = places_of(whole);
  append_rows(places_of(part), places);
  if (part.has_place() || whole.has_place()) whole.place_mm = std::move(places);
  append_rows(part.layouts, whole.layouts);
  append_rows(part.seen, whole.seen);
  if (part.time_s.size() > 0 && whole.time_s.size() > 0) {
    Eigen::VectorXd times(whole.time_s.size() + part.time_s.size());
    times << whole.time_s, part.time_s;
    whole.time_s = std::move(times);
  } else {
    whole.time_s.resize(0);
  }
  append_rows(part.force_N, whole.force_N);
  append_names(part.block, rows, before, whole.block);
  append_names(part.day, rows, before, whole.day);
  append_names(part.indenter, rows, before, whole.indenter);
  append_names(part.frame, rows, before, whole.frame);
  for (const std::string& name : part.passed_over)
    if (std::find(whole.passed_over.begin(), whole.passed_over.end(), name) ==
        whole.passed_over.end())
      whole.passed_over.push_back(name);
}

Result<ForceTable> load_part(const std::filesystem::path& file) {
  const auto content = read_file(file, ForceTable::kMostBytes);
  if (!content) return content.error();
  return ForceTable::parse_part(*content, file);
}

}  // namespace

Result<ForceTable> ForceTable::load_all(const std::vector<std::filesystem::path>& files) {
  if (files.size() == 1) return load(files.front());
  std::optional<ForceTable> whole;
  for (const std::filesystem::path& file : files) {
    auto part = load_part(file);
    if (!part) return part.error();
    const std::string name = file.stem().string();
    name_blocks_after(name, *part);
    if (!whole) {
      whole = std::move(*part);
      continue;
    }
    if (part->marker_count != whole->marker_count || part->axes != whole->axes)
      return Error{en::say("has {} markers and {} axes, the tables before it {} and {}",
                           part->marker_count,
                           part->axes,
                           whole->marker_count,
                           whole->axes),
                   file,
                   en::say("tables of one finger and one kind of gauge")};
    append_table(*part, *whole);
  }
  if (Status status = whole->check(files.front()); !status) return status.error();
  return *whole;
}

}  // namespace alltact
