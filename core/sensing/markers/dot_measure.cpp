#include "core/sensing/markers/dot_measure.h"

#include "core/numerics/dispatch.h"
#include "core/sensing/markers/dot_background.h"
#include "core/sensing/markers/dot_region.h"

#include <numbers>

#include <Eigen/Dense>

namespace alltact {
namespace {

using namespace dots;

struct Centroid {
  double x = 0, y = 0, flux = 0, spread = 0;  // spread: sum of squared distances along one axis
};

// Gradient of a dot's brightness relative to its centre. A dot lit from one side has its centroid
// of light on that side; the centre of its area is required.
struct Shading {
  double slope_x = 0, slope_y = 0;  // about the dot's centre
};

// From pixels inside the dot; zero for dots too small to have any.
Shading shading_of(const Window& w, const Background& ground, const Ellipse& e) {
  constexpr double kInside = 0.75;
  constexpr int kMinPixels = 24;
  constexpr double kMinHalfPx = 2.0;  // a thinner dot consists of its rim
  const double steepest = 0.5 * (e.xx + e.yy) + std::hypot(0.5 * (e.xx - e.yy), e.xy);
  if (steepest * kMinHalfPx * kMinHalfPx > 1.0) return {};
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
  if (n < kMinPixels) return {};
  Eigen::Matrix3d a;
  a << n, sx, sy, sx, sxx, sxy, sy, sxy, syy;
  const Eigen::Vector3d p = a.ldlt().solve(Eigen::Vector3d(s, sxv, syv));
  if (!p.allFinite() || !(p[0] > 0)) return {};
  return {p[1] / p[0], p[2] / p[0]};
}

// True when the pixel opposite the ellipse's centre is usable too.
bool opposite_usable(const Window& w, const Ellipse& e, int x, int y) {
  const int mx = static_cast<int>(std::floor(2 * e.x - x + 0.5));
  const int my = static_cast<int>(std::floor(2 * e.y - y + 0.5));
  return mx >= 0 && my >= 0 && mx < w.width && my < w.height && w.usable[w.index(mx, my)];
}

ALLTACT_WIDE void flatten_row(
    float level, float slope, float shade, float shade_slope, int width, float* values) {
  for (int x = 0; x < width; ++x) {
    const auto position = static_cast<float>(x);
    const float target = shade + shade_slope * position;
    const float above = target > 0.5F ? target : 0.5F;
    values[x] = (values[x] - (level + slope * position)) / (above < 2.0F ? above : 2.0F);
  }
}

// Converts the window's values into heights above the background, flattened by the dot's own
// shading.
void flatten(const Background& ground, const Shading& shading, const Ellipse& e, Window& w) {
  for (int y = 0; y < w.height; ++y)
    flatten_row(static_cast<float>(ground.at(0, y)),
                static_cast<float>(ground.slope_x),
                static_cast<float>(1.0 - shading.slope_x * e.x + shading.slope_y * (y - e.y)),
                static_cast<float>(shading.slope_x),
                w.width,
                &w.value[w.index(0, y)]);
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
  if (region.at_window_edge) return {std::nullopt, true};
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
  return {result, false};
}

}  // namespace

std::optional<Dot> measure_dot(const cv::Mat& grey, const SideEdges& edges, const DotSeed& seed) {
  DotSeed search_seed = seed;
  search_seed.half_u = std::clamp(seed.half_u, 1.0, 24.0);
  search_seed.half_v = std::clamp(seed.half_v, 1.0, 24.0);
  const Attempt first = attempt(grey, edges, search_seed, 2.0);
  if (first.dot || !first.too_small_window) return first.dot;
  search_seed.half_u = std::min(28.0, 2 * search_seed.half_u);
  search_seed.half_v = std::min(28.0, 2 * search_seed.half_v);
  return attempt(grey, edges, search_seed, 2.0).dot;
}

namespace {

// Images of one marker vary with distance and light, but less than this; a half-covered dot varies
// more.
bool is_similar(const Dot& dot, const Dot& like) {
  const double size = dot.radius_px / like.radius_px, strength = dot.contrast / like.contrast;
  return size > 0.7 && size < 1.4 && strength > 0.5 && strength < 2.0;
}

// The highest 3 x 3 mean on the side face within the search radius, in the polarity of `sign`.
std::optional<Eigen::Vector2d> search(const cv::Mat& grey,
                                      const SideEdges& edges,
                                      const Eigen::Vector2d& position,
                                      double search_px,
                                      bool upper,
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

std::optional<Dot> near_dot(const cv::Mat& grey,
                            const SideEdges& edges,
                            const Eigen::Vector2d& position,
                            double search_px,
                            const Dot& like) {
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
