// Which rows of a force table are held out together.
#pragma once

#include "calibration/force/force_table.h"

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace alltact {

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
[[nodiscard]] Result<ForceFolds> force_folds(const ForceTable& table,
                                             ForceSplit split,
                                             std::uint64_t seed);
inline constexpr int kStretches = 5, kMaxFolds = 10;

/// A random permutation of 0 to n - 1 by seed and purpose.
[[nodiscard]] std::vector<Eigen::Index> drawn_order(Eigen::Index n,
                                                    std::uint64_t seed,
                                                    std::string_view who,
                                                    std::uint32_t which = 0);

}  // namespace alltact
