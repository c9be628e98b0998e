#include "core/simulation/frame_geometry.h"

namespace alltact {

namespace {

PixelRays::Ray ray_of(const Camera& camera, double u, double v) {
  // Camera::create refuses distortions that leave pixels of the picture without a ray.
  const std::optional<Ray> ray = camera.unproject({u, v});
  const Ray& r = ray ? *ray : Ray{};
  return {static_cast<float>(r.origin_mm.x()),
          static_cast<float>(r.origin_mm.y()),
          static_cast<float>(r.direction.x()),
          static_cast<float>(r.direction.y())};
}

}  // namespace

PixelRays::PixelRays(const Camera& camera) : camera_(camera) {
  const cv::Size size = camera.size();
  const CameraParameters& p = camera.parameters();
  if (!camera.is_linear()) {
    map_.create(size);
    for (int v = 0; v < size.height; ++v)
      for (int u = 0; u < size.width; ++u) {
        const Ray ray = ray_of(camera, u, v);
        map_(v, u) = {ray.direction_x, ray.direction_y};
      }
    return;
  }
  for (int u = 0; u < size.width; ++u) columns_.push_back(ray_of(camera, u, p.cy_px));
  for (int v = 0; v < size.height; ++v) rows_.push_back(ray_of(camera, p.cx_px, v));
  if (camera.is_perspective())
    step_ = {0, static_cast<float>(1 / p.fy_px)};
  else
    step_ = {static_cast<float>(p.mm_per_px), 0};
}

PixelRays::Ray PixelRays::at(int u, int v) const {
  if (!linear()) return {0, 0, map_(v, u)[0], map_(v, u)[1]};
  const Ray& column = columns_[static_cast<std::size_t>(u)];
  const Ray& row = rows_[static_cast<std::size_t>(v)];
  return {column.origin_x, row.origin_y, column.direction_x, row.direction_y};
}

PixelRays::Step PixelRays::step_v(int u, int v) const {
  if (linear()) return step_;
  const int a = std::max(v - 1, 0), b = std::min(v + 1, map_.rows - 1);
  return {0, (map_(b, u)[1] - map_(a, u)[1]) / static_cast<float>(b - a)};
}

}  // namespace alltact
