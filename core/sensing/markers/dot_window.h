// Image window around one dot, and the ellipse that the dot covers in it.
#pragma once

#include "core/sensing/markers/dot_measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace alltact::dots {

constexpr int kMaxSide = 128;        // of a window, px
constexpr float kMaxLevel = 255.0F;  // values are between this and its negative

/// Image window around a seed, with the polarity inverted so that the dot is bright.
struct Window {
  int u0 = 0, v0 = 0, width = 0, height = 0;
  bool all_usable = true;  // every pixel is usable
  std::array<float, kMaxSide * kMaxSide> value;
  std::array<std::uint8_t, kMaxSide * kMaxSide> usable;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * width + x);
  }
};

/// Fills the window around a seed, `scale` times the seed's size to each side. Near the view face
/// the light that its edge spreads is subtracted, so that a dot near the edge is isolated. It is
/// estimated in the columns on both sides of the seed at the same distance from the edge.
void load(
    const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed, double scale, Window& w);

struct Ellipse {
  double x = 0, y = 0;            // centre in the window
  double xx = 1, xy = 0, yy = 1;  // inverse of the covariance of a uniform ellipse, times 1/4

  double half_x = 1, half_y = 1;  // of the box around it

  // The columns [first, last] of row y with centres inside the ellipse grown in x and y.
  struct Columns {
    int first = 0, last = -1;
  };
  [[nodiscard]] Columns columns(int row, double grow_x, double grow_y) const {
    const double dy = (row - y) / grow_y;
    const double half = xy * dy / xx;
    const double square = half * half - (yy * dy * dy - 1.0) / xx;
    if (!(square >= 0)) return {};
    const double reach = std::sqrt(square);
    return {static_cast<int>(std::ceil(x + grow_x * (-half - reach))),
            static_cast<int>(std::floor(x + grow_x * (-half + reach)))};
  }
};
/// Calls visit(row, first, last) for the columns of each of the window's rows inside the ellipse.
template <class Visit>
void for_rows_inside(const Window& w, const Ellipse& e, double grow, Visit visit) {
  const int y0 = std::max(0, static_cast<int>(e.y - grow * e.half_y));
  const int y1 = std::min(w.height - 1, static_cast<int>(e.y + grow * e.half_y) + 1);
  for (int y = y0; y <= y1; ++y) {
    const auto [first, last] = e.columns(y, grow, grow);
    visit(y, std::max(0, first), std::min(w.width - 1, last));
  }
}
}  // namespace alltact::dots
