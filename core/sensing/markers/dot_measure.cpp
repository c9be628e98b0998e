#include "core/sensing/markers/dot_measure.h"

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <Eigen/Dense>
#include <opencv2/imgproc.hpp>

namespace alltact {
namespace {

constexpr int kMaxSide = 128;  // of a window, px
constexpr std::size_t kMaxPixels = std::size_t{kMaxSide} * kMaxSide;
constexpr float kMaxLevel = 255.0F;  // values are between this and its negative

/// Image window around a seed, with the polarity inverted so that the dot is bright.
struct Window {
  int u0 = 0, v0 = 0, width = 0, height = 0;
  bool all_usable = true;  // every pixel is usable
  std::array<float, kMaxPixels> value;
  std::array<std::uint8_t, kMaxPixels> usable;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(std::ptrdiff_t{y} * width + x);
  }
};

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

constexpr double kSpreadPx = 7.0;    // distance from the edge that its light reaches
constexpr double kOwnEdgePx = 0.25;  // pixels nearer to the edge are never usable
constexpr double kBinPx = 0.5;
constexpr int kBins = 1 + static_cast<int>(kSpreadPx / kBinPx);

/// Brightness of the side face as a function of the distance from the view face's edge.
class EdgeLight {
 public:
  void add(double off_px, float value) {
    const auto bin = static_cast<std::size_t>(off_px / kBinPx);
    off_[bin] += off_px;
    value_[bin] += static_cast<double>(value);
    ++count_[bin];
  }
  /// Returns false where a distance has too few samples.
  bool finish() {
    for (int bin = 0; bin < kBins; ++bin) {
      const auto i = static_cast<std::size_t>(bin);
      if (count_[i] < kMinCount) continue;
      off_[filled_] = off_[i] / count_[i];
      value_[filled_++] = value_[i] / count_[i];
    }
    return filled_ >= 4 && off_[0] < 1.0 && off_[filled_ - 1] > kSpreadPx - 1.0;
  }
  /// Brightness above the level beyond the edge's reach.
  [[nodiscard]] double at(double off_px) const {
    std::size_t k = 1;
    while (k + 1 < filled_ && off_[k] < off_px) ++k;
    const double t = std::clamp((off_px - off_[k - 1]) / (off_[k] - off_[k - 1]), -0.5, 1.0);
    return value_[k - 1] + t * (value_[k] - value_[k - 1]) - value_[filled_ - 1];
  }
  [[nodiscard]] double level() const { return value_[filled_ - 1]; }

 private:
  static constexpr int kMinCount = 3;
  std::array<double, kBins> off_{}, value_{};
  std::array<int, kBins> count_{};
  std::size_t filled_ = 0;
};

/// Estimated in the columns next to the seed, the same number on either side.
std::optional<EdgeLight> edge_light(const cv::Mat& grey, const SideEdges& edges,
                                    const DotSeed& seed) {
  const int from = static_cast<int>(std::ceil(1.35 * seed.half_u + 2.0));
  const int to = from + std::max(6, static_cast<int>(seed.half_u));
  const int middle = static_cast<int>(std::lround(seed.u));
  if (middle - from - 2 < 0 || middle + from + 2 >= grey.cols) return std::nullopt;
  EdgeLight light;
  for (int away = from; away <= to; ++away) {
    if (middle - away < 0 || middle + away >= grey.cols) break;
    for (const int u : {middle - away, middle + away}) {
      const auto rows = edges.rows(u, seed.upper, 0.0, grey.rows);
      for (int step = 0; step <= static_cast<int>(kSpreadPx); ++step) {
        const int v = seed.upper ? rows.last - step : rows.first + step;
        if (v < 0 || v >= grey.rows) break;
        const double off = edges.off_px(u, v, seed.upper);
        if (off < kSpreadPx)
          light.add(
              off, static_cast<float>(seed.sign) * static_cast<float>(grey.at<std::uint8_t>(v, u)));
      }
    }
  }
  if (!light.finish()) return std::nullopt;
  return light;
}

/// Subtracts the edge's light from the window. The values remain integer grey levels.
void subtract_light(const EdgeLight& light, const SideEdges& edges, bool upper, Window& w) {
  for (int x = 0; x < w.width; ++x)
    for (int y = 0; y < w.height; ++y) {
      const double off = edges.off_px(w.u0 + x, w.v0 + y, upper);
      if (off >= kSpreadPx) continue;
      float& value = w.value[w.index(x, y)];
      if (off < kOwnEdgePx)
        value = static_cast<float>(std::round(light.level()));
      else
        value = std::clamp(std::round(value - static_cast<float>(light.at(off))), -kMaxLevel,
                           kMaxLevel);
    }
}

bool is_near_face(const SideEdges& edges, const DotSeed& seed, const cv::Mat& grey) {
  const int u = std::clamp(static_cast<int>(std::lround(seed.u)), 0, grey.cols - 1);
  return edges.off_px(u, seed.v, seed.upper) < seed.half_v + kSpreadPx;
}

/// Marks the window's pixels that lie on the side face, further than the margin from its edge.
void mask_usable(const SideEdges& edges, bool upper, double margin_px, int rows, Window& w) {
  std::array<int, kMaxSide> first, last;
  int all_from = 0, all_to = w.height - 1;  // rows that are usable in every column
  for (int x = 0; x < w.width; ++x) {
    const auto on_side = edges.rows(w.u0 + x, upper, margin_px, rows);
    const int from = first[static_cast<std::size_t>(x)] = on_side.first - w.v0;
    const int to = last[static_cast<std::size_t>(x)] = on_side.last - w.v0;
    all_from = std::max(all_from, from);
    all_to = std::min(all_to, to);
  }
  w.all_usable = all_from == 0 && all_to == w.height - 1;
  for (int y = 0; y < w.height; ++y) {
    std::uint8_t* usable = &w.usable[w.index(0, y)];
    if (all_from <= y && y <= all_to) {
      std::fill_n(usable, w.width, std::uint8_t{1});
      continue;
    }
    for (int x = 0; x < w.width; ++x) {
      const auto column = static_cast<std::size_t>(x);
      usable[x] = static_cast<std::uint8_t>((y >= first[column]) & (y <= last[column]));
    }
  }
}

/// Fills the window around a seed, twice the seed's size to each side. Near the view face
/// the light that its edge spreads is subtracted, so that a dot near the edge is isolated. It is
/// estimated in the columns on both sides of the seed at the same distance from the edge.
void load(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed, Window& w) {
  constexpr double kScale = 2.0;
  const int half_u =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(kScale * seed.half_u + 3)));
  const int half_v =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(kScale * seed.half_v + 3)));
  const int cu = static_cast<int>(std::lround(seed.u)), cv = static_cast<int>(std::lround(seed.v));
  w.u0 = std::max(0, cu - half_u);
  w.v0 = std::max(0, cv - half_v);
  w.width = std::min(grey.cols - 1, cu + half_u) - w.u0 + 1;
  w.height = std::min(grey.rows - 1, cv + half_v) - w.v0 + 1;
  if (w.width <= 0 || w.height <= 0) {
    w.width = w.height = 0;
    return;
  }
  const auto sign = static_cast<float>(seed.sign);
  for (int y = 0; y < w.height; ++y) {
    const std::uint8_t* row = grey.ptr<std::uint8_t>(w.v0 + y) + w.u0;
    float* out = &w.value[w.index(0, y)];
    for (int x = 0; x < w.width; ++x) out[x] = sign * static_cast<float>(row[x]);
  }
  double margin_px = kFaceMarginPx;
  if (is_near_face(edges, seed, grey))
    if (const auto light = edge_light(grey, edges, seed)) {
      subtract_light(*light, edges, seed.upper, w);
      margin_px = kOwnEdgePx;
    }
  mask_usable(edges, seed.upper, margin_px, grey.rows, w);
}

/// Centre and second moments in the window's pixels, and the type of its boundary.
struct Region {
  int area = 0;
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  double sum = 0;  // of heights above the level
  bool at_window_edge = false, at_border = false, at_face = false;
};

constexpr double kMaxAspect = 20.0;  // side faces are imaged at a grazing angle
constexpr double kMinArea = 4.0;     // pixels at half height

/// Marks the usable pixels above the threshold with 1, others with 0.
ALLTACT_WIDE void mark_above(const float* value, const std::uint8_t* usable, float threshold,
                             std::size_t count, std::uint8_t* above) {
  for (std::size_t i = 0; i < count; ++i)
    above[i] =
        static_cast<std::uint8_t>(usable[i] & static_cast<std::uint8_t>(value[i] > threshold));
}

// Fills a region run by run: each run adds the adjacent runs above and below. Values are integer
// grey levels and positions integers, so that all sums are exact.
class RegionFill {
 public:
  RegionFill(const Window& w, float threshold, int x, int y, const cv::Size& image_size)
      : w_(w), x_(x), y_(y), image_size_(image_size) {
    mark_above(w.value.data(), w.usable.data(), threshold,
               static_cast<std::size_t>(w.width) * static_cast<std::size_t>(w.height),
               waits_.data());
  }

  Region operator()() {
    begin(x_, y_);
    while (count_ > 0) {
      const std::uint16_t i = starts_[static_cast<std::size_t>(--count_)];
      if (waits_[i] == kWaits) add_run(i % w_.width, i / w_.width);
    }
    return region_;
  }

 private:
  static constexpr std::uint8_t kWaits = 1, kAdded = 2;  // of pixels above the threshold

  void begin(int x, int y) {
    const std::size_t i = w_.index(x, y);
    if (waits_[i] == kWaits)
      starts_[static_cast<std::size_t>(count_++)] = static_cast<std::uint16_t>(i);
  }

  void add_run(int x, int y) {
    std::uint8_t* row = &waits_[w_.index(0, y)];
    int first = x, last = x;
    while (first > 0 && row[first - 1] != 0) --first;
    while (last + 1 < w_.width && row[last + 1] != 0) ++last;
    mark_boundary(first - 1, y);
    mark_boundary(last + 1, y);
    std::fill(row + first, row + last + 1, kAdded);
    const int n = last - first + 1;
    const double dy = y - y_;
    const auto squares_below = [](std::int64_t k) { return k * (k + 1) * (2 * k + 1) / 6; };
    const double sum_x = 0.5 * n * (first - x_ + last - x_);
    const auto sum_xx =
        static_cast<double>(squares_below(last - x_) - squares_below(first - x_ - 1));
    int sum = 0;
    for (int column = first; column <= last; ++column)
      sum += static_cast<int>(w_.value[w_.index(column, y)]);
    region_.sum += sum;
    region_.area += n;
    region_.x += sum_x;
    region_.y += n * dy;
    region_.xx += sum_xx;
    region_.xy += sum_x * dy;
    region_.yy += n * dy * dy;
    for (const int neighbour : {y - 1, y + 1}) {
      if (neighbour < 0 || neighbour >= w_.height)
        mark_boundary(first, neighbour);
      else
        add_neighbours(first, last, neighbour);
    }
  }

  void add_neighbours(int first, int last, int y) {
    const std::uint8_t* row = &waits_[w_.index(0, y)];
    std::uint8_t before = 0;
    for (int column = first; column <= last; ++column) {
      if (row[column] == kWaits && before == 0) begin(column, y);
      before = row[column];
    }
    if (w_.all_usable || region_.at_face) return;
    const std::uint8_t* usable = &w_.usable[w_.index(0, y)];
    region_.at_face = std::find(usable + first, usable + last + 1, 0) != usable + last + 1;
  }

  // Records what bounds the region at (x, y).
  void mark_boundary(int x, int y) {
    if (x >= 0 && y >= 0 && x < w_.width && y < w_.height) {
      region_.at_face = region_.at_face || !w_.usable[w_.index(x, y)];
      return;
    }
    const int u = w_.u0 + x, v = w_.v0 + y;
    const bool outside = u < 0 || v < 0 || u >= image_size_.width || v >= image_size_.height;
    (outside ? region_.at_border : region_.at_window_edge) = true;
  }

  const Window& w_;
  int x_, y_;
  cv::Size image_size_;
  Region region_;  // moments about (x_, y_), not yet divided by the area
  std::array<std::uint8_t, kMaxPixels> waits_;
  std::array<std::uint16_t, kMaxPixels> starts_;
  int count_ = 0;
};

/// The pixels connected to (x, y) that are higher than `height` above the surrounding level.
Region grow(const Window& w, double level, int x, int y, double height,
            const cv::Size& image_size) {
  Region region = RegionFill(w, static_cast<float>(level + height), x, y, image_size)();
  if (region.area == 0) return region;
  const double n = region.area;
  region.sum -= n * level;
  region.x /= n;
  region.y /= n;
  // 1/12: variance of a pixel's extent.
  region.xx = region.xx / n - region.x * region.x + 1.0 / 12;
  region.xy = region.xy / n - region.x * region.y;
  region.yy = region.yy / n - region.y * region.y + 1.0 / 12;
  region.x += x;
  region.y += y;
  return region;
}
/// True for the area of a uniform ellipse, 4 pi sqrt(det covariance); ragged regions have less.
bool is_compact(const Region& region) {
  if (region.area < kMinArea) return false;
  const double det = region.xx * region.yy - region.xy * region.xy;
  const double trace = region.xx + region.yy;
  if (!(det > 0)) return false;
  const double gap = std::sqrt(std::max(0.0, 0.25 * trace * trace - det));
  const double aspect = std::sqrt((0.5 * trace + gap) / std::max(1e-9, 0.5 * trace - gap));
  const double fill = region.area / (4 * std::numbers::pi * std::sqrt(det));
  return aspect <= kMaxAspect && fill > 0.78;
}
/// The uniform ellipse with the region's moments.
Ellipse ellipse_of(const Region& region) {
  Ellipse e;
  e.x = region.x;
  e.y = region.y;
  const double det = region.xx * region.yy - region.xy * region.xy;
  e.half_x = 2 * std::sqrt(region.xx);
  e.half_y = 2 * std::sqrt(region.yy);
  e.xx = 0.25 * region.yy / det;
  e.yy = 0.25 * region.xx / det;
  e.xy = -0.25 * region.xy / det;
  return e;
}

struct Background {
  double level = 0, slope_x = 0, slope_y = 0;  // at the origin of the window's coordinates (x, y)
  double noise = 0;

  [[nodiscard]] double at(double x, double y) const { return level + slope_x * x + slope_y * y; }
};

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
        count += ((x < first) | (x > last)) ? w.usable[i] : 0;
      }
    }
  }

  // The values are integer grey levels of either sign.
  [[nodiscard]] float median() const {
    constexpr int kMaxGrey = static_cast<int>(kMaxLevel);
    std::array<std::int32_t, 2 * kMaxGrey + 1> histogram{};
    for (int k = 0; k < count; ++k)
      ++histogram[static_cast<std::size_t>(std::ptrdiff_t{kMaxGrey} +
                                           static_cast<int>(value[static_cast<std::size_t>(k)]))];
    int level = 0;
    for (int below = 0; below <= count / 2; ++level)
      below += histogram[static_cast<std::size_t>(level)];
    return static_cast<float>(level - 1 - kMaxGrey);
  }

  std::array<float, kMaxPixels> value;
  std::array<std::uint8_t, kMaxPixels> x_of, y_of;
  int count = 0;
};

/// Coarse level and noise around an ellipse grown in x and y: enough to detect a dot. nullopt: too
/// few pixels are usable.
std::optional<Background> level_around(const Window& w, const Ellipse& inner, double grow_x,
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

/// Plane through the pixels around the ellipse that are within `spread` of their median. Only
/// pixels of the ring count, so that a second dot or the side face's far edge has no influence
/// unless it fills half of it. nullopt: too few pixels are usable.
std::optional<Background> plane_around(const Window& w, const Ellipse& inner, double grow,
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

struct Centroid {
  double x = 0, y = 0, flux = 0, spread = 0;  // spread: sum of squared distances along one axis
};

// Gradient of a dot's brightness relative to its centre, about that centre. A dot lit from one side
// has its centroid of light on that side; the centre of its area is required. From pixels inside
// the dot; zero for dots too small to have any.
Eigen::Vector2d shading_of(const Window& w, const Background& ground, const Ellipse& e) {
  constexpr double kInside = 0.75;
  constexpr int kMinPixels = 24;
  constexpr double kMinHalfPx = 2.0;  // a thinner dot consists of its rim
  const double steepest = 0.5 * (e.xx + e.yy) + std::hypot(0.5 * (e.xx - e.yy), e.xy);
  if (steepest * kMinHalfPx * kMinHalfPx > 1.0) return Eigen::Vector2d::Zero();
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0, s = 0, sxv = 0, syv = 0;
  for_rows_inside(w, e, kInside, [&](int y, int first, int last) {
    const double dy = y - e.y;
    for (int x = first; x <= last; ++x) {
      const std::size_t i = w.index(x, y);
      if (!w.usable[i]) continue;
      const double dx = x - e.x;
      const double height = static_cast<double>(w.value[i]) - ground.at(x, y);
      n += 1, sx += dx, sy += dy, sxx += dx * dx, sxy += dx * dy, syy += dy * dy;
      s += height, sxv += dx * height, syv += dy * height;
    }
  });
  if (n < kMinPixels) return Eigen::Vector2d::Zero();
  Eigen::Matrix3d a;
  a << n, sx, sy, sx, sxx, sxy, sy, sxy, syy;
  const Eigen::Vector3d p = a.ldlt().solve(Eigen::Vector3d(s, sxv, syv));
  if (!p.allFinite() || !(p[0] > 0)) return Eigen::Vector2d::Zero();
  return {p[1] / p[0], p[2] / p[0]};
}

// True when the pixel opposite the ellipse's centre is usable too.
bool opposite_usable(const Window& w, const Ellipse& e, int x, int y) {
  const int mx = static_cast<int>(std::floor(2 * e.x - x + 0.5));
  const int my = static_cast<int>(std::floor(2 * e.y - y + 0.5));
  return mx >= 0 && my >= 0 && mx < w.width && my < w.height && w.usable[w.index(mx, my)];
}

ALLTACT_WIDE void flatten_row(float level, float slope, float shade, float shade_slope, int width,
                              float* values) {
  for (int x = 0; x < width; ++x) {
    const auto position = static_cast<float>(x);
    const float target = shade + shade_slope * position;
    const float above = target > 0.5F ? target : 0.5F;
    values[x] = (values[x] - (level + slope * position)) / (above < 2.0F ? above : 2.0F);
  }
}

// Converts the window's values into heights above the background, flattened by the dot's own
// shading.
void flatten(const Background& ground, const Eigen::Vector2d& shading, const Ellipse& e,
             Window& w) {
  for (int y = 0; y < w.height; ++y)
    flatten_row(static_cast<float>(ground.at(0, y)), static_cast<float>(ground.slope_x),
                static_cast<float>(1.0 - shading.x() * e.x + shading.y() * (y - e.y)),
                static_cast<float>(shading.x()), w.width, &w.value[w.index(0, y)]);
}

// Centroid of signed heights inside the grown ellipse: noise that is not clipped at zero causes no
// bias.
Centroid centroid(const Window& w, const Ellipse& e, double reach) {
  Centroid c;
  double square = 0;
  // Neither the view face nor the window's border is near.
  const bool lone = w.all_usable && e.x - reach * e.half_x > 1 && e.y - reach * e.half_y > 1 &&
                    e.x + reach * e.half_x < w.width - 2 && e.y + reach * e.half_y < w.height - 2;
  for_rows_inside(w, e, reach, [&](int y, int first, int last) {
    const double dy = y - e.y;
    double flux = 0;
    for (int x = first; x <= last; ++x) {
      const std::size_t i = w.index(x, y);
      if (!lone && !(w.usable[i] && opposite_usable(w, e, x, y))) continue;
      const double dx = x - e.x, height = static_cast<double>(w.value[i]);
      c.x += height * dx;
      flux += height;
      square += dx * dx + dy * dy;
    }
    c.y += flux * dy;
    c.flux += flux;
  });
  if (!(c.flux > 0)) return {};
  c.x = e.x + c.x / c.flux;
  c.y = e.y + c.y / c.flux;
  c.spread = 0.5 * square;
  return c;
}

// The highest 3 x 3 mean near the seed, so that a seed next to the dot still finds it.
std::optional<std::pair<int, int>> summit(const Window& w, const DotSeed& seed) {
  const int cx = static_cast<int>(std::lround(seed.u)) - w.u0;
  const int cy = static_cast<int>(std::lround(seed.v)) - w.v0;
  const int reach_x = std::clamp(static_cast<int>(0.5 * seed.half_u), 1, 6);
  const int reach_y = std::clamp(static_cast<int>(0.5 * seed.half_v), 1, 6);
  float best = -1e30F;
  std::optional<std::pair<int, int>> position;
  for (int y = std::max(1, cy - reach_y); y <= std::min(w.height - 2, cy + reach_y); ++y)
    for (int x = std::max(1, cx - reach_x); x <= std::min(w.width - 2, cx + reach_x); ++x) {
      float sum = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) sum += w.value[w.index(x + dx, y + dy)];
      if (sum <= best || !w.usable[w.index(x, y)]) continue;
      best = sum;
      position = {x, y};
    }
  return position;
}

/// nullopt: no lone compact spot; `is_window_too_small` is set where one may reach further.
std::optional<Dot> measure_once(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed,
                                bool& is_window_too_small) {
  Window w;
  load(grey, edges, seed, w);
  const auto top = summit(w, seed);
  if (!top) return {};
  const auto [x, y] = *top;
  Ellipse rough;
  rough.x = x;
  rough.y = y;
  rough.half_x = seed.half_u;
  rough.half_y = seed.half_v;
  rough.xx = 1 / (seed.half_u * seed.half_u);
  rough.yy = 1 / (seed.half_v * seed.half_v);
  const auto first = level_around(w, rough, 1.5 + 1.5 / seed.half_u, 1.5 + 1.5 / seed.half_v);
  if (!first) return {};
  float peak = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) peak += w.value[w.index(x + dx, y + dy)] / 9;
  const double height = peak - first->level;
  if (height < std::max(seed.min_contrast, 2.0 * first->noise / 3)) return {};
  Region region = grow(w, first->level, x, y, 0.5 * height, grey.size());
  if (region.at_border || region.at_face) return {};
  is_window_too_small = region.at_window_edge;
  if (region.at_window_edge) return {};
  if (!is_compact(region)) return {};

  const Ellipse dot = ellipse_of(region);
  const double radius = std::sqrt(region.area / std::numbers::pi);
  const double ring = 1.35 + 1.5 / radius;
  const auto ground = plane_around(w, dot, ring, 0.3 * height + 3);
  if (!ground) return {};
  Centroid c;
  Ellipse moving = dot;
  flatten(*ground, shading_of(w, *ground, dot), dot, w);
  for (int pass = 0; pass < 2; ++pass) {
    c = centroid(w, moving, 1.2 + 1.2 / radius);
    if (!(c.flux > 0) || std::hypot(c.x - dot.x, c.y - dot.y) > 0.5 * radius + 0.5) return {};
    moving.x = c.x;
    moving.y = c.y;
  }
  Dot result;
  result.u = w.u0 + c.x;
  result.v = w.v0 + c.y;
  const double mean_height = region.sum / region.area;
  result.contrast = seed.sign * mean_height;
  result.radius_px = std::sqrt(c.flux / mean_height / std::numbers::pi);
  result.half_u_px = dot.half_x;
  result.half_v_px = dot.half_y;
  // 0.3: rounding to integer grey levels. The plane's own error adds about as much as the pixels'.
  const double noise = std::max(0.3, ground->noise);
  result.sd_px = std::sqrt(std::pow(1.2 * noise * std::sqrt(c.spread) / c.flux, 2) + 0.01 * 0.01);
  result.upper = seed.upper;
  return result;
}

}  // namespace

std::optional<Dot> measure_dot(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed) {
  DotSeed search_seed = seed;
  search_seed.half_u = std::clamp(seed.half_u, 1.0, 24.0);
  search_seed.half_v = std::clamp(seed.half_v, 1.0, 24.0);
  bool is_window_too_small = false;
  const auto dot = measure_once(grey, edges, search_seed, is_window_too_small);
  if (!is_window_too_small) return dot;
  search_seed.half_u = std::min(28.0, 2 * search_seed.half_u);
  search_seed.half_v = std::min(28.0, 2 * search_seed.half_v);
  return measure_once(grey, edges, search_seed, is_window_too_small);
}

namespace {

// Images of one marker vary with distance and light, but less than this; a half-covered dot varies
// more.
bool is_similar(const Dot& dot, const Dot& like) {
  const double size = dot.radius_px / like.radius_px, strength = dot.contrast / like.contrast;
  return size > 0.7 && size < 1.4 && strength > 0.5 && strength < 2.0;
}

// The highest 3 x 3 mean on the side face within the search radius, in the polarity of `sign`.
std::optional<Eigen::Vector2d> search(const cv::Mat& grey, const SideEdges& edges,
                                      const Eigen::Vector2d& position, double search_px, bool upper,
                                      int sign) {
  const int u0 = std::max(1, static_cast<int>(position.x() - search_px));
  const int u1 = std::min(grey.cols - 2, static_cast<int>(position.x() + search_px + 1));
  int best = std::numeric_limits<int>::min();
  std::optional<Eigen::Vector2d> summit;
  for (int u = u0; u <= u1; ++u) {
    const auto rows = edges.rows(u, upper, kFaceMarginPx + 1, grey.rows);
    const int v0 = std::max({1, rows.first, static_cast<int>(position.y() - search_px)});
    const int v1 =
        std::min({grey.rows - 2, rows.last, static_cast<int>(position.y() + search_px + 1)});
    for (int v = v0; v <= v1; ++v) {
      int sum = 0;
      for (int dv = -1; dv <= 1; ++dv) {
        const std::uint8_t* row = grey.ptr<std::uint8_t>(v + dv) + u;
        sum += row[-1] + row[0] + row[1];
      }
      if (sign * sum <= best) continue;
      best = sign * sum;
      summit = Eigen::Vector2d(u, v);
    }
  }
  return summit;
}

}  // namespace

bool is_among(const std::vector<Dot>& dots, const Dot& dot) {
  return std::any_of(dots.begin(), dots.end(), [&](const Dot& other) {
    return std::hypot(other.u - dot.u, other.v - dot.v) < std::max(1.5, 0.8 * other.radius_px);
  });
}

cv::Mat reduced_for_dots(const cv::Mat& grey, int* factor) {
  const int f =
      std::max(1, static_cast<int>(std::lround(static_cast<double>(grey.cols) / kReducedWidthPx)));
  *factor = f;
  if (f == 1) return grey;
  cv::Mat reduced;
  cv::resize(grey(cv::Rect(0, 0, grey.cols / f * f, grey.rows / f * f)), reduced,
             cv::Size(grey.cols / f, grey.rows / f), 0, 0, cv::INTER_AREA);
  return reduced;
}

std::optional<Dot> near_dot(const cv::Mat& grey, const SideEdges& edges,
                            const Eigen::Vector2d& position, double search_px, const Dot& like) {
  if (!(position.x() >= 0 && position.x() <= grey.cols - 1 && position.y() >= 0 &&
        position.y() <= grey.rows - 1))
    return std::nullopt;
  DotSeed seed;
  seed.u = position.x();
  seed.v = position.y();
  // A dot seen at a grazing angle is far wider than high.
  seed.half_u = like.half_u_px > 0 ? like.half_u_px : like.radius_px;
  seed.half_v = like.half_v_px > 0 ? like.half_v_px : like.radius_px;
  seed.upper = position.y() < edges.middle(static_cast<int>(std::lround(position.x())));
  seed.sign = like.contrast > 0 ? 1 : -1;
  seed.min_contrast = std::max(3.0, 0.4 * std::abs(like.contrast));
  const auto accepted = [&](const std::optional<Dot>& dot) {
    return dot && is_similar(*dot, like) &&
           std::hypot(dot->u - position.x(), dot->v - position.y()) <= search_px + 1;
  };
  auto dot = measure_dot(grey, edges, seed);
  if (accepted(dot)) return dot;
  const auto summit = search(grey, edges, position, search_px, seed.upper, seed.sign > 0 ? 1 : -1);
  if (!summit) return std::nullopt;
  seed.u = summit->x();
  seed.v = summit->y();
  dot = measure_dot(grey, edges, seed);
  return accepted(dot) ? dot : std::nullopt;
}

}  // namespace alltact
