// Layouts of the markers and forces of a gauge, row by row: the training data of a force model, and
// which rows are held out together.
#pragma once

#include "core/base/message.h"
#include "core/base/result.h"

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

/// A table of any form that core/base/table.h describes. The case of names is ignored, and their
/// unit (_px, _mm, _n, _s) is optional:
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
  std::vector<Message> understood, remarks;              ///< those of Table, of each file

  [[nodiscard]] Eigen::Index rows() const { return force_N.rows(); }
  [[nodiscard]] bool has_position() const { return position_mm.rows() > 0; }

  /// Errors name file, line and column: those of Table, missing columns, a cell that is no finite
  /// number, and those of check().
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

}  // namespace alltact
