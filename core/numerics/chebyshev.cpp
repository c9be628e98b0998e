#include "core/numerics/chebyshev.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>

namespace alltact {
namespace {

constexpr int kBlock = 64;  // values that stay in the cache through the recurrence

/// Clenshaw's recurrence for a block of positions, one coefficient at a time.
ALLTACT_WIDE void clenshaw_block(
    const double* c, int count, double first, double step, int offset, double* values) {
  std::array<double, kBlock> t, next, after;
  for (int i = 0; i < kBlock; ++i) {
    t[static_cast<std::size_t>(i)] = first + static_cast<double>(offset + i) * step;
    next[static_cast<std::size_t>(i)] = after[static_cast<std::size_t>(i)] = 0.0;
  }
  for (int k = count - 1; k >= 1; --k) {
    for (std::size_t i = 0; i < kBlock; ++i) {
      const double value = 2.0 * t[i] * next[i] - after[i] + c[k];
      after[i] = next[i];
      next[i] = value;
    }
  }
  for (std::size_t i = 0; i < kBlock; ++i) values[i] = t[i] * next[i] - after[i] + c[0];
}

}  // namespace

void chebyshev_values(const Eigen::VectorXd& c, double first, double step, int n, double* values) {
  const auto count = static_cast<int>(c.size());
  if (count == 0) return std::fill_n(values, n, 0.0), void();
  std::array<double, kBlock> block;
  for (int offset = 0; offset < n; offset += kBlock) {
    const int used = std::min(kBlock, n - offset);
    clenshaw_block(
        c.data(), count, first, step, offset, used == kBlock ? values + offset : block.data());
    if (used < kBlock) std::copy_n(block.begin(), used, values + offset);
  }
}

}  // namespace alltact
