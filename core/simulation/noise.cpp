#include "core/simulation/noise.h"

#include "core/numerics/dispatch.h"
#include "core/numerics/philox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace alltact {
namespace {

constexpr int kQuantiles = 1 << 16;
constexpr int kLanes = 32;            // counters processed in parallel
constexpr int kPixelsPerCounter = 8;  // 128 bits make eight 16-bit indices

// The middle quantile of each of 64 Ki equally likely slices, scaled to unit variance.
std::vector<float> make_quantiles() {
  std::vector<double> half;  // upper half, ascending
  double x = 0, sum2 = 0;
  for (int i = kQuantiles / 2; i < kQuantiles; ++i) {
    const double tail = 1 - (i + 0.5) / kQuantiles;
    for (int k = 0; k < 50; ++k) {  // Newton's method on the tail probability, from below
      const double density = std::exp(-0.5 * x * x) / std::sqrt(2 * std::numbers::pi);
      const double step = (0.5 * std::erfc(x / std::numbers::sqrt2) - tail) / density;
      x += step;
      if (std::abs(step) < 1e-13) break;
    }
    half.push_back(x);
    sum2 += x * x;
  }
  const double scale = 1 / std::sqrt(2 * sum2 / kQuantiles);
  std::vector<float> table(kQuantiles);
  for (int i = 0; i < kQuantiles / 2; ++i) {
    const auto value = static_cast<float>(scale * half[static_cast<std::size_t>(i)]);
    table[static_cast<std::size_t>(std::ptrdiff_t{kQuantiles / 2} + i)] = value;
    table[static_cast<std::size_t>(kQuantiles / 2 - 1 - i)] = -value;
  }
  return table;
}

const float* quantiles() {
  static const std::vector<float> kTable = make_quantiles();
  return kTable.data();
}

// Philox for kLanes counters that differ in their first word. Bitwise equal to philox().
ALLTACT_WIDE void philox_lanes(std::uint32_t first, std::uint32_t c1, std::uint32_t c2,
                               std::uint32_t c3, std::uint32_t k0, std::uint32_t k1,
                               std::uint32_t* __restrict bits) {
  std::uint32_t a[kLanes], b[kLanes], c[kLanes], d[kLanes];
  for (std::uint32_t i = 0; i < kLanes; ++i) {
    a[i] = first + i;
    b[i] = c1;
    c[i] = c2;
    d[i] = c3;
  }
  for (int round = 0; round < kPhiloxRounds; ++round) {
    for (int i = 0; i < kLanes; ++i) {
      const std::uint64_t p0 = std::uint64_t{kPhiloxMultiplier0} * a[i];
      const std::uint64_t p1 = std::uint64_t{kPhiloxMultiplier1} * c[i];
      a[i] = static_cast<std::uint32_t>(p1 >> 32) ^ b[i] ^ k0;
      c[i] = static_cast<std::uint32_t>(p0 >> 32) ^ d[i] ^ k1;
      b[i] = static_cast<std::uint32_t>(p1);
      d[i] = static_cast<std::uint32_t>(p0);
    }
    k0 += kPhiloxWeyl0;
    k1 += kPhiloxWeyl1;
  }
  for (std::ptrdiff_t i = 0; i < kLanes; ++i) {
    bits[4 * i] = a[i];
    bits[4 * i + 1] = b[i];
    bits[4 * i + 2] = c[i];
    bits[4 * i + 3] = d[i];
  }
}

}  // namespace

RowNoise::RowNoise(std::string_view stream) : stream_(fnv1a(stream)) { quantiles(); }

void RowNoise::normals(std::uint64_t seed, int frame, int row, int n, float* out) const {
  const float* table = quantiles();
  std::array<std::uint32_t, std::size_t{4} * kLanes> bits;
  for (int at = 0; at < n; at += kLanes * kPixelsPerCounter) {
    philox_lanes(static_cast<std::uint32_t>(at / kPixelsPerCounter),
                 static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(frame),
                 static_cast<std::uint32_t>(seed >> 32), static_cast<std::uint32_t>(seed), stream_,
                 bits.data());
    const int count = std::min(kLanes * kPixelsPerCounter, n - at);
    for (int i = 0; i < count; ++i) {
      const std::uint32_t word = bits[static_cast<std::size_t>(i / 2)];
      out[at + i] = table[i % 2 == 0 ? word & 0xFFFFU : word >> 16];
    }
  }
}

}  // namespace alltact
