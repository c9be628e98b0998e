// Where the markers were and what force a gauge told, row by row: what a force model is trained on.
#pragma once

#include "core/result.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A table is a CSV file (commas, '.' in numbers) whose first line names the columns. Names are
/// compared without regard to case, and a unit behind them (_px, _mm, _n, _s) may be left out:
///   u0, v0, u1, v1, ...   px, the markers by number (x00, y00, ... as well); empty: not seen
///   seen0, seen1, ...     1 or 0; absent: those are seen that have a position
///   fx_n, fy_n[, fz_n]    N, what pressed on the finger
///   along_mm, across_mm   where it pressed, from the face's base and its middle; both or neither;
///                         empty: not known
///   t_s                   when
///   block, day, indenter  names of what the row belongs to: pressed in one go, on one day, with
///                         one tool; such rows must not stand on both sides of a split
///   frame                 name of the picture
/// Other columns are passed over.
struct ForceTable {
  static constexpr std::size_t kLeastRows = 20;
  static constexpr std::size_t kMostBytes = std::size_t{1} << 30;

  int marker_count = 0;
  int axes = 2;              ///< 2: Fx, Fy; 3: Fz too
  Eigen::MatrixXd layouts;   ///< one row a frame, (u0, v0, ...), px; 0 where not seen
  Eigen::MatrixXd seen;      ///< 1 or 0, one column a marker
  Eigen::MatrixXd force_N;   ///< one column an axis
  Eigen::MatrixXd place_mm;  ///< along and across, NaN where not known; no rows: never known
  Eigen::VectorXd time_s;    ///< of no size: not known
  std::vector<std::string> block, day, indenter, frame;  ///< empty: not told
  std::vector<std::string> passed_over;                  ///< columns

  [[nodiscard]] Eigen::Index rows() const { return force_N.rows(); }
  [[nodiscard]] bool has_place() const { return place_mm.rows() > 0; }

  /// Errors name file, line and column: columns that are missing or given twice, a cell that is no
  /// finite number, lines with too few cells, and those of check().
  static Result<ForceTable> parse(std::string_view csv, const std::filesystem::path& origin);
  static Result<ForceTable> load(const std::filesystem::path& file);
  /// A table that need not be learnt from alone, such as one with pushes in one direction: without
  /// check(), but at least one row.
  static Result<ForceTable> parse_part(std::string_view csv, const std::filesystem::path& origin);
  /// Several tables as one, each block named after its file where there are several. Errors: those
  /// of parse_part, other numbers of markers or axes, and those of check() of them all.
  static Result<ForceTable> load_all(const std::vector<std::filesystem::path>& files);
  /// Whether something can be learnt: at least kLeastRows rows, forces that change, markers that
  /// move. An fz that is exactly 0 everywhere is passed over: gauges that tell one direction leave
  /// it so.
  [[nodiscard]] Status check(const std::filesystem::path& origin);
  /// What load() reads as the same values.
  [[nodiscard]] std::string to_csv() const;
};

}  // namespace alltact
