#include "core/sensing/markers/dot_background.h"

#include <Eigen/Dense>

namespace alltact::dots {
namespace {

// Pixels of the window outside the grown ellipse and within a slightly larger box.
class Ring {
 public:
  Ring(const Window& w, const Ellipse& inner, double grow_x, double grow_y, int stride) {
    const double reach_x = 1.4 * grow_x * inner.half_x + 3,
                 reach_y = 1.4 * grow_y * inner.half_y + 3;
    const int x0 = std::max(0, static_cast<int>(inner.x - reach_x));
    const int x1 = std::min(w.width - 1, static_cast<int>(inner.x + reach_x) + 1);
    const int y0 = std::max(0, static_cast<int>(inner.y - reach_y));
    const int y1 = std::min(w.height - 1, static_cast<int>(inner.y + reach_y) + 1);
    for (int y = y0; y <= y1; y += stride) {
      const auto [first, last] = inner.columns(y, grow_x, grow_y);
      for (int x = x0; x <= x1; x += stride) {
        const std::size_t i = w.index(x, y);
        value[static_cast<std::size_t>(count)] = w.value[i];
        x_of[static_cast<std::size_t>(count)] = static_cast<std::uint8_t>(x);
        y_of[static_cast<std::size_t>(count)] = static_cast<std::uint8_t>(y);
        count += (x < first) | (x > last) ? w.usable[i] : 0;
      }
    }
  }

  // The values are integer grey levels of either sign.
  [[nodiscard]] float median() const {
    constexpr int kMaxGrey = static_cast<int>(kMaxLevel);
    std::array<std::int32_t, 2 * kMaxGrey + 1> histogram{};
    for (int k = 0; k < count; ++k)
      ++histogram[static_cast<std::size_t>(kMaxGrey +
                                           static_cast<int>(value[static_cast<std::size_t>(k)]))];
    int level = 0;
    for (int below = 0; below <= count / 2; ++level)
      below += histogram[static_cast<std::size_t>(level)];
    return static_cast<float>(level - 1 - kMaxGrey);
  }

  std::array<float, kMaxSide * kMaxSide> value;
  std::array<std::uint8_t, kMaxSide * kMaxSide> x_of, y_of;
  int count = 0;
};
}  // namespace

std::optional<Background> level_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow_x,
                                       double grow_y) {
  const int stride = 1 + std::max(w.width, w.height) / 24;
  Ring ring(w, inner, grow_x, grow_y, stride);
  if (ring.count < 8) return std::nullopt;
  Background result;
  const float level = ring.median();
  for (int k = 0; k < ring.count; ++k) {
    float& value = ring.value[static_cast<std::size_t>(k)];
    value = std::abs(value - level);
  }
  result.level = level;
  result.noise = 1.4826 * static_cast<double>(ring.median());
  return result;
}

std::optional<Background> plane_around(const Window& w,
                                       const Ellipse& inner,
                                       double grow,
                                       double spread) {
  // Large dots have more surroundings than the plane needs.
  const int stride = 1 + std::max(w.width, w.height) / 48;
  const Ring ring(w, inner, grow, grow, stride);
  if (ring.count < 8) return std::nullopt;
  const double median = ring.median();
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, s = 0, sxv = 0, syv = 0, square = 0;
  for (int k = 0; k < ring.count; ++k) {
    const auto i = static_cast<std::size_t>(k);
    const double value = static_cast<double>(ring.value[i]) - median;
    if (std::abs(value) > spread) continue;
    const double x = ring.x_of[i] - inner.x, y = ring.y_of[i] - inner.y;
    n += 1;
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
    syy += y * y;
    s += value;
    sxv += x * value;
    syv += y * value;
    square += value * value;
  }
  if (n < 8) return std::nullopt;
  // A small ridge on the slopes: the view face may cut the ring down to a line, which has no second
  // slope.
  Eigen::Matrix3d a;
  a << n, sx, sy, sx, 1.001 * sxx + 1.0, sxy, sy, sxy, 1.001 * syy + 1.0;
  const Eigen::Vector3d b(s, sxv, syv);
  const Eigen::Vector3d p = a.ldlt().solve(b);
  if (!p.allFinite()) return std::nullopt;
  Background result;
  result.slope_x = p[1];
  result.slope_y = p[2];
  result.level = median + p[0] - p[1] * inner.x - p[2] * inner.y;
  result.noise = std::sqrt(std::max(0.0, square - b.dot(p)) / std::max(1.0, n - 3));
  return result;
}
}  // namespace alltact::dots
