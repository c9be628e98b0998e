#include "core/sensing/markers/dot_region.h"

#include <numbers>

#include <Eigen/Dense>

namespace alltact::dots {
namespace {

constexpr double kMaxAspect = 20.0;  // side faces are imaged at a grazing angle
constexpr double kMinArea = 4.0;     // pixels at half height

// Fills a region run by run: each run adds the adjacent runs above and below.
class RegionFill {
 public:
  RegionFill(const Window& w, float threshold, int x, int y, const cv::Size& image_size)
      : w_(w), threshold_(threshold), x_(x), y_(y), image_size_(image_size) {
    std::fill_n(seen_.begin(), w.width * w.height, std::uint8_t{0});
  }

  Region operator()() {
    begin(x_, y_);
    while (count_ > 0) {
      const std::uint16_t i = starts_[static_cast<std::size_t>(--count_)];
      if (!seen_[i]) add_run(i % w_.width, i / w_.width);
    }
    return region_;
  }

 private:
  [[nodiscard]] bool stands_out(std::size_t i) const {
    return w_.usable[i] && w_.value[i] > threshold_;
  }
  void begin(int x, int y) {
    const std::size_t i = w_.index(x, y);
    if (!seen_[i] && stands_out(i))
      starts_[static_cast<std::size_t>(count_++)] = static_cast<std::uint16_t>(i);
  }

  void add_run(int x, int y) {
    int first = x, last = x;
    while (first > 0 && stands_out(w_.index(first - 1, y))) --first;
    while (last + 1 < w_.width && stands_out(w_.index(last + 1, y))) ++last;
    mark_boundary(first - 1, y);
    mark_boundary(last + 1, y);
    const double dy = y - y_;
    double sum_x = 0, sum_xx = 0;
    for (int column = first; column <= last; ++column) {
      const std::size_t i = w_.index(column, y);
      seen_[i] = 1;
      const double dx = column - x_;
      sum_x += dx;
      sum_xx += dx * dx;
      region_.sum += static_cast<double>(w_.value[i]);
    }
    const int n = last - first + 1;
    region_.area += n;
    region_.x += sum_x;
    region_.y += n * dy;
    region_.xx += sum_xx;
    region_.xy += sum_x * dy;
    region_.yy += n * dy * dy;
    for (const int neighbour : {y - 1, y + 1}) {
      if (neighbour < 0 || neighbour >= w_.height) {
        mark_boundary(first, neighbour);
        continue;
      }
      bool before = false;
      for (int column = first; column <= last; ++column) {
        const std::size_t i = w_.index(column, neighbour);
        region_.at_face = region_.at_face || !w_.usable[i];
        const bool here = stands_out(i);
        if (here && !before) begin(column, neighbour);
        before = here;
      }
    }
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
  float threshold_;
  int x_, y_;
  cv::Size image_size_;
  Region region_;  // moments about (x_, y_), not yet divided by the area
  std::array<std::uint8_t, kMaxSide * kMaxSide> seen_;
  std::array<std::uint16_t, kMaxSide * kMaxSide> starts_;
  int count_ = 0;
};
}  // namespace

Region grow(
    const Window& w, double level, int x, int y, double height, const cv::Size& image_size) {
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
}  // namespace alltact::dots
