#include "core/sensing/markers/paper_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Core>

namespace alltact {
namespace {

constexpr double kMinSdPx = 1.0;  // of an unseen marker
// Fraction of a step, where the row is too short to estimate it
constexpr double kTypicalBending = 0.3;
// Costs of a dot one step from its last position, and of a number skipped at the base without a
// last position. For comparison: a step of twice its neighbour costs 0.48.
constexpr double kMovedCost = 0.01, kLeftOutCost = 0.01;
constexpr double kNoNumbering = std::numeric_limits<double>::infinity();

std::vector<Dot> sorted_row(const std::vector<Dot>& dots,
                            bool upper,
                            std::size_t per_row,
                            bool base_at_low_u) {
  std::vector<Dot> row;
  std::copy_if(dots.begin(), dots.end(), std::back_inserter(row), [upper](const Dot& dot) {
    return dot.upper == upper;
  });
  std::stable_sort(row.begin(), row.end(), [](const Dot& a, const Dot& b) {
    return std::abs(a.contrast) > std::abs(b.contrast);
  });
  if (row.size() > per_row) row.resize(per_row);
  std::stable_sort(row.begin(), row.end(), [base_at_low_u](const Dot& a, const Dot& b) {
    return base_at_low_u ? a.u < b.u : a.u > b.u;
  });
  return row;
}

Eigen::Vector2d position(const Dot& dot) {
  return {dot.u, dot.v};
}

/// Numbers of a row's dots, by dynamic programming over neighbours. The cost sums the squared
/// logarithms of step ratios, to the neighbours' or to the previous steps. The squared
/// displacements since then have a far lower weight.
class RowNumbers {
 public:
  /// before: the row's previous markers; nullptr: unknown.
  RowNumbers(const std::vector<Dot>& row, int per_row, const Marker* before)
      : row_(row), before_(before), max_skips_(per_row - static_cast<int>(row.size())) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      steps_px_.push_back(std::max(1e-3, (position(row[i + 1]) - position(row[i])).norm()));
  }

  [[nodiscard]] std::vector<int> operator()() const {
    const std::size_t n = row_.size();
    const std::size_t skips = static_cast<std::size_t>(max_skips_) + 1;
    if (n == 1) return {lone_number()};
    // cost(i, a, b): the minimum over the dots up to i with a numbers skipped before dot i - 1 and
    // b before dot i.
    const auto at = [skips](std::size_t i, int a, int b) {
      return (i * skips + static_cast<std::size_t>(a)) * skips + static_cast<std::size_t>(b);
    };
    std::vector<double> cost(n * skips * skips, kNoNumbering);
    std::vector<int> before(cost.size(), -1);
    for (int a = 0; a <= max_skips_; ++a)
      for (int b = a; b <= max_skips_; ++b)
        cost[at(1, a, b)] = moved(0, a) + moved(1, b) + (before_ ? stretched(1, a, b) : 0.0);
    for (std::size_t i = 2; i < n; ++i)
      for (int a = 0; a <= max_skips_; ++a)
        for (int b = a; b <= max_skips_; ++b)
          for (int c = b; c <= max_skips_; ++c) {
            const double uneven = before_ ? stretched(i, b, c) : bend_at(i, a, b, c);
            const double total = cost[at(i - 1, a, b)] + uneven + moved(i, c);
            if (total >= cost[at(i, b, c)]) continue;
            cost[at(i, b, c)] = total;
            before[at(i, b, c)] = a;
          }
    int b = 0, c = 0;
    for (int x = 0; x <= max_skips_; ++x)
      for (int y = x; y <= max_skips_; ++y)
        if (cost[at(n - 1, x, y)] < cost[at(n - 1, b, c)]) b = x, c = y;
    std::vector<int> numbers(n);
    for (std::size_t i = n - 1; i >= 1; --i) {
      numbers[i] = static_cast<int>(i) + c;
      const int a = before[at(i, b, c)];
      c = b;
      b = a;
    }
    numbers[0] = c;
    return numbers;
  }

 private:
  [[nodiscard]] double bend_at(std::size_t i, int a, int b, int c) const {
    const double first = steps_px_[i - 2] / (1 + b - a), second = steps_px_[i - 1] / (1 + c - b);
    return std::pow(std::log(second / first), 2);
  }
  /// Cost of the step to dot i relative to its previous length.
  [[nodiscard]] double stretched(std::size_t i, int a, int b) const {
    const Marker& from = before_[i - 1 + static_cast<std::size_t>(a)];
    const Marker& to = before_[i + static_cast<std::size_t>(b)];
    const double was_px = std::max(1e-3, std::hypot(to.u - from.u, to.v - from.v));
    return std::pow(std::log(steps_px_[i - 1] / was_px), 2);
  }
  /// Cost of the displacement of dot i with `skipped` numbers before it.
  [[nodiscard]] double moved(std::size_t i, int skipped) const {
    if (!before_) return kLeftOutCost * skipped;
    const Marker& was = before_[i + static_cast<std::size_t>(skipped)];
    const double step_px = steps_px_.empty() ? 1.0 : steps_px_[std::min(i, steps_px_.size() - 1)];
    return kMovedCost * std::pow(std::hypot(row_[i].u - was.u, row_[i].v - was.v) / step_px, 2);
  }
  [[nodiscard]] int lone_number() const {
    int best = 0;
    for (int number = 1; number <= max_skips_; ++number)
      if (moved(0, number) < moved(0, best)) best = number;
    return best;
  }

  const std::vector<Dot>& row_;
  const Marker* before_;
  int max_skips_;  // maximum of skipped numbers
  std::vector<double> steps_px_;
};

/// Root mean square difference of neighbouring steps of the row in u and v, px. It is the second
/// difference over one number in each direction, of every seen marker between seen ones.
double bending_px(const Markers& row, const std::vector<int>& seen) {
  const auto marker = [&](std::size_t i) -> const Marker& {
    return row[static_cast<std::size_t>(seen[i])];
  };
  double square = 0;
  for (std::size_t i = 1; i + 1 < seen.size(); ++i) {
    const double before = seen[i] - seen[i - 1], after = seen[i + 1] - seen[i];
    const Marker &a = marker(i - 1), &b = marker(i), &c = marker(i + 1);
    const double part = before / (before + after);
    const double off_u = b.u - a.u - part * (c.u - a.u), off_v = b.v - a.v - part * (c.v - a.v);
    square += std::pow(2.0 / (before * after), 2) * (off_u * off_u + off_v * off_v);
  }
  if (seen.size() > 2) return std::sqrt(square / (2.0 * static_cast<double>(seen.size() - 2)));
  const Marker &a = marker(0), &b = marker(1);
  return kTypicalBending * std::hypot(b.u - a.u, b.v - a.v) / (seen[1] - seen[0]);
}

/// Estimates the unseen markers of a row with at least two seen ones.
void fill_from_neighbours(Markers& row) {
  std::vector<int> seen;
  for (std::size_t i = 0; i < row.size(); ++i)
    if (row[i].seen) seen.push_back(static_cast<int>(i));
  const double half_bending_px = 0.5 * bending_px(row, seen);
  for (int i = 0; i < static_cast<int>(row.size()); ++i) {
    Marker& marker = row[static_cast<std::size_t>(i)];
    if (marker.seen) continue;
    // The seen ones on both sides; at an end the last two.
    auto after =
        static_cast<std::size_t>(std::lower_bound(seen.begin(), seen.end(), i) - seen.begin());
    after = std::clamp<std::size_t>(after, 1, seen.size() - 1);
    const int a = seen[after - 1], b = seen[after];
    const Marker &from = row[static_cast<std::size_t>(a)], &to = row[static_cast<std::size_t>(b)];
    const double part = static_cast<double>(i - a) / (b - a);
    const double off_px = half_bending_px * std::abs((i - a) * (i - b));
    marker = {from.u + part * (to.u - from.u),
              from.v + part * (to.v - from.v),
              false,
              std::max(kMinSdPx, off_px)};
  }
}

}  // namespace

std::optional<Markers> paper_rows(const std::vector<Dot>& dots,
                                  int per_row,
                                  bool base_at_low_u,
                                  const Markers* before) {
  if (per_row < 1) return std::nullopt;
  const auto length = static_cast<std::size_t>(per_row);
  if (before && before->size() != 2 * length) before = nullptr;
  Markers markers;
  for (const bool is_upper : {true, false}) {
    const auto found = sorted_row(dots, is_upper, length, base_at_low_u);
    if (found.size() < std::min<std::size_t>(2, length)) return std::nullopt;
    const auto numbers =
        RowNumbers(found, per_row, before ? before->data() + markers.size() : nullptr)();
    Markers row(length);
    for (std::size_t i = 0; i < found.size(); ++i)
      row[static_cast<std::size_t>(numbers[i])] = {found[i].u, found[i].v, true, found[i].sd_px};
    if (found.size() < length) fill_from_neighbours(row);
    markers.insert(markers.end(), row.begin(), row.end());
  }
  return markers;
}

}  // namespace alltact
