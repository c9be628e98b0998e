#include "core/sensing/markers/marker_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

constexpr double kNone = std::numeric_limits<double>::infinity();

// Neighbours in a row are similar after correction for perspective. Log ratios make growth and
// shrinkage cost the same. Light falls off along the row, so contrast has a low weight.
double dissimilarity(const Dot& a, const Dot& b) {
  const double size = std::log(b.radius_px * a.face_px / (a.radius_px * b.face_px));
  const double contrast = std::log(std::abs(b.contrast) / std::abs(a.contrast));
  const double off_face = b.off_face - a.off_face;
  return 0.5 * size * size + 0.15 * contrast * contrast + 20.0 * off_face * off_face;
}

// Cost of unequal neighbouring steps along the finger: (b - a)^2 / (a b), 1/2 where a dot is
// missing.
double bend(const Dot& p, const Dot& q, const Dot& r) {
  const double a = q.along_mm - p.along_mm, b = r.along_mm - q.along_mm;
  return a > 0 && b > 0 ? (b - a) * (b - a) / (a * b) : kNone;
}

}  // namespace

std::optional<DotRow> choose_row(const std::vector<Dot>& dots,
                                 bool upper,
                                 int per_row,
                                 bool base_at_low_u) {
  std::vector<int> side;
  for (std::size_t i = 0; i < dots.size(); ++i)
    if (dots[i].upper == upper) side.push_back(static_cast<int>(i));
  const int n = static_cast<int>(side.size());
  if (n < per_row) return std::nullopt;
  std::sort(side.begin(), side.end(), [&](int a, int b) {
    const double ua = dots[static_cast<std::size_t>(a)].u, ub = dots[static_cast<std::size_t>(b)].u;
    return base_at_low_u ? ua < ub : ua > ub;
  });
  const auto dot = [&](int i) -> const Dot& {
    return dots[static_cast<std::size_t>(side[static_cast<std::size_t>(i)])];
  };
  // cost(count, i, j): the cheapest row of `count` dots that ends with i, j.
  const auto at = [n](int count, int i, int j) {
    return (static_cast<std::size_t>(count) * static_cast<std::size_t>(n) +
            static_cast<std::size_t>(i)) *
               static_cast<std::size_t>(n) +
           static_cast<std::size_t>(j);
  };
  const std::size_t size = at(per_row, n - 1, n - 1) + 1;
  std::vector<double> cost(size, kNone);
  std::vector<int> before(size, -1);
  for (int j = 1; j < n; ++j)
    for (int i = 0; i < j; ++i) cost[at(2, i, j)] = dissimilarity(dot(i), dot(j));
  for (int count = 3; count <= per_row; ++count)
    for (int k = 2; k < n; ++k)
      for (int j = 1; j < k; ++j) {
        const double step = dissimilarity(dot(j), dot(k));
        for (int i = 0; i < j; ++i) {
          const double before_cost = cost[at(count - 1, i, j)];
          if (before_cost == kNone) continue;
          const double total = before_cost + step + bend(dot(i), dot(j), dot(k));
          if (total >= cost[at(count, j, k)]) continue;
          cost[at(count, j, k)] = total;
          before[at(count, j, k)] = i;
        }
      }
  double best = kNone;
  int i = -1, j = -1;
  for (int b = 1; b < n; ++b)
    for (int a = 0; a < b; ++a)
      if (cost[at(per_row, a, b)] < best) best = cost[at(per_row, a, b)], i = a, j = b;
  if (i < 0) return std::nullopt;
  DotRow row;
  row.unevenness = best / per_row;
  row.dots.push_back(side[static_cast<std::size_t>(j)]);
  for (int count = per_row; i >= 0; --count) {
    row.dots.push_back(side[static_cast<std::size_t>(i)]);
    const int previous = count > 2 ? before[at(count, i, j)] : -1;
    j = i;
    i = previous;
  }
  std::reverse(row.dots.begin(), row.dots.end());
  return row;
}

std::optional<std::vector<Dot>> two_rows(const std::vector<Dot>& dots,
                                         int per_row,
                                         bool base_at_low_u) {
  std::vector<Dot> markers;
  for (const bool is_upper : {true, false}) {
    const auto row = choose_row(dots, is_upper, per_row, base_at_low_u);
    if (!row || row->unevenness > kMaxUnevenness) return std::nullopt;
    for (const int d : row->dots) markers.push_back(dots[static_cast<std::size_t>(d)]);
  }
  return markers;
}

}  // namespace alltact
