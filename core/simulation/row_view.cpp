#include "core/simulation/row_view.h"

namespace alltact {
namespace {

Ray ray_of(const Camera& camera, double u, double v) {
  // Camera::create refuses distortions that leave pixels of the image without a ray.
  return camera.unproject({u, v}).value_or(Ray{});
}

}  // namespace

PixelRays::PixelRays(const Camera& camera) : camera_(camera) {
  const cv::Size size = camera.size();
  const CameraParameters& p = camera.parameters();
  if (!camera.is_linear()) {
    map_.create(size);
    if (camera.parameters().port) origins_.create(size);
    for (int v = 0; v < size.height; ++v)
      for (int u = 0; u < size.width; ++u) {
        const Ray ray = ray_of(camera, u, v);
        map_(v, u) = {static_cast<float>(ray.direction.x()), static_cast<float>(ray.direction.y())};
        if (origins_.empty()) continue;
        origins_(v, u) = {static_cast<float>(ray.origin_mm.x()),
                          static_cast<float>(ray.origin_mm.y())};
      }
    return;
  }
  for (int u = 0; u < size.width; ++u) {
    const Ray ray = ray_of(camera, u, p.cy_px);
    origin_x_.push_back(static_cast<float>(ray.origin_mm.x()));
    direction_x_.push_back(static_cast<float>(ray.direction.x()));
  }
  for (int v = 0; v < size.height; ++v) {
    const Ray ray = ray_of(camera, p.cx_px, v);
    rows_.push_back({static_cast<float>(ray.origin_mm.y()), static_cast<float>(ray.direction.y())});
  }
}

Ray PixelRays::ray(int u, int v) const {
  if (linear()) {
    const RowRay row = row_ray(v);
    return {{origin_x(u), row.origin_y, 0}, {direction_x(u), row.direction_y, 1}};
  }
  Ray ray;
  ray.direction = {map_(v, u)[0], map_(v, u)[1], 1};
  if (!origins_.empty()) ray.origin_mm = {origins_(v, u)[0], origins_(v, u)[1], 0};
  return ray;
}

RayRow PixelRays::row(int v, RowScratch& scratch) const {
  const int n = camera_.size().width;
  float *direction_y = scratch.floats(), *step_y = scratch.floats();
  if (linear()) {
    std::fill(direction_y, direction_y + n, row_ray(v).direction_y);
    std::fill(step_y, step_y + n, static_cast<float>(1 / camera_.parameters().fy_px));
    return {direction_x_.data(), direction_y, step_y};
  }
  float* direction_x = scratch.floats();
  const int a = std::max(v - 1, 0), b = std::min(v + 1, map_.rows - 1);
  const auto *here = map_[v], *above = map_[a], *below = map_[b];
  for (int u = 0; u < n; ++u) {
    direction_x[u] = here[u][0];
    direction_y[u] = here[u][1];
    step_y[u] = (below[u][1] - above[u][1]) / static_cast<float>(b - a);
  }
  return {direction_x, direction_y, step_y};
}

std::pair<float, float> PixelRays::direction_x_range() const {
  std::pair<float, float> range{map_(0, 0)[0], map_(0, 0)[0]};
  for (const cv::Vec2f& direction : map_) {
    range.first = std::min(range.first, direction[0]);
    range.second = std::max(range.second, direction[0]);
  }
  return range;
}

}  // namespace alltact
