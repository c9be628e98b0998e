#include "core/sensing/dot_measure.h"

#include <array>
#include <cstdint>
#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kMaxSide = 128;       // of a window, px
constexpr double kMaxAspect = 20.0;  // side faces are seen at a grazing angle
constexpr double kLeastArea = 4.0;  // px at half height

// The part of the picture around a seed, polarity turned so that the dot is bright.
struct Window {
  int u0 = 0, v0 = 0, width = 0, height = 0;
  std::array<float, kMaxSide * kMaxSide> value;
  std::array<std::uint8_t, kMaxSide * kMaxSide> usable;

  [[nodiscard]] std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y * width + x);
  }
};

void load(
    const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed, double scale, Window& w) {
  const int half_u =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(scale * seed.half_u + 3)));
  const int half_v =
      std::min(kMaxSide / 2 - 1, static_cast<int>(std::ceil(scale * seed.half_v + 3)));
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
  for (int x = 0; x < w.width; ++x) {
    const auto rows = edges.rows(w.u0 + x, seed.upper, kFaceMarginPx, grey.rows);
    for (int y = 0; y < w.height; ++y)
      w.usable[w.index(x, y)] = w.v0 + y >= rows.first && w.v0 + y <= rows.last;
  }
}

struct Background {
  double level = 0, slope_x = 0, slope_y = 0;  // at window centre of coordinates (x, y)
  double noise = 0;
  int count = 0;

  [[nodiscard]] double at(double x, double y) const { return level + slope_x * x + slope_y * y; }
};

struct Ellipse {
  double x = 0, y = 0;            // centre in the window
  double xx = 1, xy = 0, yy = 1;  // inverse of the covariance of a uniform ellipse, times 1/4

  // < 1 inside the ellipse itself.
  [[nodiscard]] double square(double dx, double dy) const {
    return dx * dx * xx + 2 * dx * dy * xy + dy * dy * yy;
  }
};

// Plane through the pixels around the ellipse that lie near their median. Only pixels of the ring
// count, so that a second dot or the side face's far edge has no say unless it fills half of it.
std::optional<Background> background_around(
    const Window& w, const Ellipse& inner, double grow_u, double grow_v, double spread) {
  std::array<float, kMaxSide * kMaxSide> ring_value;
  std::array<std::uint16_t, kMaxSide * kMaxSide> ring_place;
  int n = 0;
  for (int y = 0; y < w.height; ++y)
    for (int x = 0; x < w.width; ++x) {
      const std::size_t i = w.index(x, y);
      if (!w.usable[i]) continue;
      const double dx = (x - inner.x) / grow_u, dy = (y - inner.y) / grow_v;
      if (inner.square(dx, dy) <= 1.0) continue;
      ring_value[static_cast<std::size_t>(n)] = w.value[i];
      ring_place[static_cast<std::size_t>(n++)] = static_cast<std::uint16_t>(i);
    }
  if (n < 8) return std::nullopt;
  std::array<float, kMaxSide* kMaxSide>& sorted = ring_value;
  std::nth_element(sorted.begin(), sorted.begin() + n / 2, sorted.begin() + n);
  const double median = sorted[static_cast<std::size_t>(n / 2)];
  // Normal equations of the plane about the ellipse's centre.
  Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  double square = 0;
  int used = 0;
  for (int k = 0; k < n; ++k) {
    const int i = ring_place[static_cast<std::size_t>(k)];
    const double value = w.value[static_cast<std::size_t>(i)] - median;
    if (std::abs(value) > spread) continue;
    const Eigen::Vector3d g(1.0, i % w.width - inner.x, i / w.width - inner.y);
    a.noalias() += g * g.transpose();
    b += g * value;
    square += value * value;
    ++used;
  }
  if (used < 8) return std::nullopt;
  // A little ridge on the slopes: a ring cut down to a line by the view face has no second slope.
  a(1, 1) += 1e-3 * a(1, 1) + 1.0;
  a(2, 2) += 1e-3 * a(2, 2) + 1.0;
  const Eigen::Vector3d p = a.ldlt().solve(b);
  if (!p.allFinite()) return std::nullopt;
  Background result;
  result.slope_x = p[1];
  result.slope_y = p[2];
  result.level = median + p[0] - p[1] * inner.x - p[2] * inner.y;
  result.noise = std::sqrt(std::max(0.0, square - b.dot(p)) / std::max(1, used - 3));
  result.count = used;
  return result;
}

struct Region {
  int area = 0;
  double x = 0, y = 0, xx = 0, xy = 0, yy = 0;
  double sum = 0;  // of heights
  bool at_window_edge = false, at_border = false, at_face = false;
};

// The pixels connected to (x, y) that stand higher than `height` above the background.
Region grow(const Window& w,
            const Background& ground,
            int x,
            int y,
            double height,
            const cv::Size& picture) {
  Region region;
  std::array<std::uint8_t, kMaxSide * kMaxSide> seen;
  std::fill_n(seen.begin(), w.width * w.height, std::uint8_t{0});
  std::array<std::uint16_t, kMaxSide * kMaxSide> queue;
  int head = 0, tail = 0;
  const auto push = [&](int px, int py) {
    if (px < 0 || py < 0 || px >= w.width || py >= w.height) {
      const int u = w.u0 + px, v = w.v0 + py;
      if (u < 0 || v < 0 || u >= picture.width || v >= picture.height)
        region.at_border = true;
      else
        region.at_window_edge = true;
      return;
    }
    const std::size_t i = w.index(px, py);
    if (seen[i]) return;
    seen[i] = 1;
    if (!w.usable[i]) {
      region.at_face = true;
      return;
    }
    if (w.value[i] - ground.at(px, py) <= height) return;
    queue[static_cast<std::size_t>(tail++)] = static_cast<std::uint16_t>(i);
  };
  push(x, y);
  while (head < tail) {
    const int i = queue[static_cast<std::size_t>(head++)];
    const int px = i % w.width, py = i / w.width;
    const double dx = px - x, dy = py - y;
    region.x += dx;
    region.y += dy;
    region.xx += dx * dx;
    region.xy += dx * dy;
    region.yy += dy * dy;
    region.sum += w.value[static_cast<std::size_t>(i)] - ground.at(px, py);
    ++region.area;
    push(px - 1, py);
    push(px + 1, py);
    push(px, py - 1);
    push(px, py + 1);
  }
  if (region.area == 0) return region;
  const double n = region.area;
  region.x /= n;
  region.y /= n;
  // 1/12: the spread of a pixel itself.
  region.xx = region.xx / n - region.x * region.x + 1.0 / 12;
  region.xy = region.xy / n - region.x * region.y;
  region.yy = region.yy / n - region.y * region.y + 1.0 / 12;
  region.x += x;
  region.y += y;
  return region;
}

// A uniform ellipse has area 4 pi sqrt(det covariance); anything ragged has less.
bool is_compact(const Region& region) {
  if (region.area < kLeastArea) return false;
  const double det = region.xx * region.yy - region.xy * region.xy;
  const double trace = region.xx + region.yy;
  if (!(det > 0)) return false;
  const double gap = std::sqrt(std::max(0.0, 0.25 * trace * trace - det));
  const double aspect = std::sqrt((0.5 * trace + gap) / std::max(1e-9, 0.5 * trace - gap));
  const double fill = region.area / (4 * std::numbers::pi * std::sqrt(det));
  return aspect <= kMaxAspect && fill > 0.78;
}

Ellipse ellipse_of(const Region& region) {
  Ellipse e;
  e.x = region.x;
  e.y = region.y;
  const double det = region.xx * region.yy - region.xy * region.xy;
  e.xx = 0.25 * region.yy / det;
  e.yy = 0.25 * region.xx / det;
  e.xy = -0.25 * region.xy / det;
  return e;
}

struct Centroid {
  double x = 0, y = 0, flux = 0, spread = 0;  // spread: sum of squared distances, one axis
};

// Signed heights inside the grown ellipse: noise that is not cut off at zero does not pull.
Centroid centroid(const Window& w, const Background& ground, const Ellipse& e, double reach) {
  Centroid c;
  double square = 0;
  for (int y = 0; y < w.height; ++y)
    for (int x = 0; x < w.width; ++x) {
      const double dx = x - e.x, dy = y - e.y;
      if (e.square(dx, dy) > reach * reach) continue;
      if (!w.usable[w.index(x, y)]) continue;
      const int mx = static_cast<int>(std::lround(2 * e.x - x));
      const int my = static_cast<int>(std::lround(2 * e.y - y));
      const bool inside = mx >= 0 && my >= 0 && mx < w.width && my < w.height;
      if (!inside || !w.usable[w.index(mx, my)]) continue;
      const double height = w.value[w.index(x, y)] - ground.at(x, y);
      c.x += height * dx;
      c.y += height * dy;
      c.flux += height;
      square += dx * dx + dy * dy;
    }
  if (!(c.flux > 0)) return {};
  c.x = e.x + c.x / c.flux;
  c.y = e.y + c.y / c.flux;
  c.spread = 0.5 * square;
  return c;
}

// The highest 3 x 3 mean near the seed, so that a seed beside the dot still finds it.
std::optional<std::pair<int, int>> summit(const Window& w, const DotSeed& seed) {
  const int cx = static_cast<int>(std::lround(seed.u)) - w.u0;
  const int cy = static_cast<int>(std::lround(seed.v)) - w.v0;
  const int reach_x = std::max(1, static_cast<int>(0.5 * seed.half_u));
  const int reach_y = std::max(1, static_cast<int>(0.5 * seed.half_v));
  float best = -1e30F;
  std::optional<std::pair<int, int>> place;
  for (int y = std::max(1, cy - reach_y); y <= std::min(w.height - 2, cy + reach_y); ++y)
    for (int x = std::max(1, cx - reach_x); x <= std::min(w.width - 2, cx + reach_x); ++x) {
      float sum = 0;
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) sum += w.value[w.index(x + dx, y + dy)];
      if (sum <= best || !w.usable[w.index(x, y)]) continue;
      best = sum;
      place = {x, y};
    }
  return place;
}

struct Attempt {
  std::optional<Dot> dot;
  bool too_small_window = false;
};

Attempt attempt(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed, double scale) {
  Window w;
  load(grey, edges, seed, scale, w);
  const auto top = summit(w, seed);
  if (!top) return {};
  const auto [x, y] = *top;
  Ellipse rough;
  rough.x = x;
  rough.y = y;
  rough.xx = 1 / (seed.half_u * seed.half_u);
  rough.yy = 1 / (seed.half_v * seed.half_v);
  const auto first =
      background_around(w, rough, 1.5 + 1.5 / seed.half_u, 1.5 + 1.5 / seed.half_v, 1e9);
  if (!first) return {};
  float peak = 0;
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) peak += w.value[w.index(x + dx, y + dy)] / 9;
  const double height = peak - first->at(x, y);
  if (height < std::max(seed.least_contrast, 2.0 * first->noise / 3)) return {};
  Region region = grow(w, *first, x, y, 0.5 * height, grey.size());
  if (region.at_border || region.at_face) return {};
  if (region.at_window_edge) return {std::nullopt, true};
  if (!is_compact(region)) return {};

  const Ellipse dot = ellipse_of(region);
  const double radius = std::sqrt(region.area / std::numbers::pi);
  const double ring = 1.35 + 1.5 / radius;
  const auto ground = background_around(w, dot, ring, ring, 0.3 * height + 3);
  if (!ground) return {};
  Centroid c;
  Ellipse moving = dot;
  for (int pass = 0; pass < 2; ++pass) {
    c = centroid(w, *ground, moving, 1.2 + 1.2 / radius);
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
  // 0.3: rounding to whole grey levels. The plane's own error adds about as much as the pixels'.
  const double noise = std::max(0.3, ground->noise);
  result.sd_px = std::sqrt(std::pow(1.2 * noise * std::sqrt(c.spread) / c.flux, 2) + 0.01 * 0.01);
  result.upper = seed.upper;
  return {result, false};
}

}  // namespace

std::optional<Dot> measure_dot(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed) {
  DotSeed look = seed;
  look.half_u = std::clamp(seed.half_u, 1.0, 24.0);
  look.half_v = std::clamp(seed.half_v, 1.0, 24.0);
  const Attempt first = attempt(grey, edges, look, 2.0);
  if (first.dot || !first.too_small_window) return first.dot;
  look.half_u = std::min(28.0, 2 * look.half_u);
  look.half_v = std::min(28.0, 2 * look.half_v);
  return attempt(grey, edges, look, 2.0).dot;
}

namespace {

// Dots of one marker differ from picture to picture with distance and light, but not by more than
// this; a dot half covered does.
bool looks_like(const Dot& dot, double radius_px, double contrast) {
  const double size = dot.radius_px / radius_px, strength = dot.contrast / contrast;
  return size > 0.7 && size < 1.4 && strength > 0.5 && strength < 2.0;
}

// The highest 3 x 3 mean on the side face within the search, in the polarity of `sign`.
std::optional<Eigen::Vector2d> search(const cv::Mat& grey,
                                      const SideEdges& edges,
                                      const Eigen::Vector2d& place,
                                      double search_px,
                                      bool upper,
                                      int sign) {
  const int u0 = std::max(1, static_cast<int>(place.x() - search_px));
  const int u1 = std::min(grey.cols - 2, static_cast<int>(place.x() + search_px + 1));
  int best = std::numeric_limits<int>::min();
  std::optional<Eigen::Vector2d> summit;
  for (int u = u0; u <= u1; ++u) {
    const auto rows = edges.rows(u, upper, kFaceMarginPx + 1, grey.rows);
    const int v0 = std::max({1, rows.first, static_cast<int>(place.y() - search_px)});
    const int v1 =
        std::min({grey.rows - 2, rows.last, static_cast<int>(place.y() + search_px + 1)});
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

std::optional<Dot> near_dot(const cv::Mat& grey,
                            const SideEdges& edges,
                            const Eigen::Vector2d& place,
                            double search_px,
                            double radius_px,
                            double contrast) {
  if (!(place.x() >= 0 && place.x() <= grey.cols - 1 && place.y() >= 0 &&
        place.y() <= grey.rows - 1))
    return std::nullopt;
  DotSeed seed;
  seed.u = place.x();
  seed.v = place.y();
  seed.half_u = seed.half_v = radius_px;
  seed.upper = place.y() < edges.middle(static_cast<int>(std::lround(place.x())));
  seed.sign = contrast > 0 ? 1 : -1;
  seed.least_contrast = std::max(3.0, 0.4 * std::abs(contrast));
  const auto accepted = [&](const std::optional<Dot>& dot) {
    return dot && looks_like(*dot, radius_px, contrast) &&
           std::hypot(dot->u - place.x(), dot->v - place.y()) <= search_px + 1;
  };
  auto dot = measure_dot(grey, edges, seed);
  if (accepted(dot)) return dot;
  const auto summit = search(grey, edges, place, search_px, seed.upper, seed.sign > 0 ? 1 : -1);
  if (!summit) return std::nullopt;
  seed.u = summit->x();
  seed.v = summit->y();
  dot = measure_dot(grey, edges, seed);
  return accepted(dot) ? dot : std::nullopt;
}

}  // namespace alltact
