#include "calibration/force/force_split.h"

#include "core/numerics/philox.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace alltact {
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

std::vector<Eigen::Index> ForceFolds::rows_in(int fold) const {
  return rows_where(of, fold, true);
}
std::vector<Eigen::Index> ForceFolds::rows_without(int fold) const {
  return rows_where(of, fold, false);
}

std::vector<Eigen::Index> drawn_order(Eigen::Index n,
                                      std::uint64_t seed,
                                      std::string_view who,
                                      std::uint32_t which) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(n));
  std::iota(order.begin(), order.end(), 0);
  for (std::size_t i = order.size(); i > 1; --i) {
    const double drawn = philox_uniform(seed, who, which, static_cast<std::uint32_t>(i));
    std::swap(order[i - 1], order[std::min(i - 1, static_cast<std::size_t>(drawn * i))]);
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
               std::string("--split"),
               en::say("--split block, or a table of several")};
}

}  // namespace alltact
