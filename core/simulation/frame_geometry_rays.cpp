#include "core/simulation/frame_geometry.h"
#include "core/simulation/ruled_surface.h"

namespace alltact {

namespace {

// Buffers of the face's row.
struct FaceArrays {
  explicit FaceArrays(RowScratch& scratch) {
    for (float** array :
         {&x, &y, &z, &normal_x, &normal_y, &normal_z, &cos, &luf, &shift, &s, &coverage, &light})
      *array = scratch.floats();
  }
  float *x, *y, *z, *normal_x, *normal_y, *normal_z, *cos, *luf, *shift, *s, *coverage, *light;

  void set(int u, const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
    x[u] = static_cast<float>(point.x());
    y[u] = static_cast<float>(point.y());
    z[u] = static_cast<float>(point.z());
    normal_x[u] = static_cast<float>(-normal.x());
    normal_y[u] = static_cast<float>(-normal.y());
    normal_z[u] = static_cast<float>(-normal.z());
    cos[u] = static_cast<float>(normal.z());
    light[u] = 1;
  }
  // No coverage; the numbers only have to be finite.
  void miss(int u) {
    set(u, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ());
    luf[u] = 1;
    s[u] = kNoHit_mm;
    shift[u] = coverage[u] = 0;
  }
};

double share(double inside_px) {
  return std::clamp(inside_px + 0.5, 0.0, 1.0);
}

}  // namespace

Surface FrameGeometry::fill_by_rays(RowView& row) const {
  FaceArrays arrays(row.scratch);
  const auto n = static_cast<std::size_t>(row.width);
  std::vector<Ray> rays(n);
  for (int u = 0; u < row.width; ++u) rays[static_cast<std::size_t>(u)] = rays_.ray(u, row.v);
  std::optional<RuledSurface::IntersectionRow> intersections;
  if (curve_)
    intersections = RuledSurface::view_face(*curve_).intersect_row(rays, std::vector<char>(n, 1));
  for (int u = 0; u < row.width; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const Ray& ray = rays[i];
    if (!intersections) {
      arrays.set(u, ray.point_at(face_.plane_z_mm), Eigen::Vector3d::UnitZ());
      arrays.luf[u] = static_cast<float>(face_.layer_mm);
      arrays.s[u] = arrays.x[u];
      arrays.shift[u] = 0;
      arrays.coverage[u] = 1;
      continue;
    }
    if (!intersections->is_hit(i)) {
      arrays.miss(u);
      continue;
    }
    const RuledSurface::Intersection here = intersections->at(i);
    arrays.set(u, ray.point_at(here.z_mm), here.normal);
    arrays.luf[u] = static_cast<float>(face_.layer_mm / here.normal.z());
    arrays.s[u] = static_cast<float>(here.s_mm);
    arrays.shift[u] = arrays.y[u] - static_cast<float>(here.r_mm);
    const double ends = std::min(here.s_mm, curve_->length_mm() - here.s_mm);
    const double edges = face_.width_mm / 2 - std::abs(here.r_mm);
    const double margin_mm = kEdgeMargin_px * rays_.camera().mm_per_px_at(here.z_mm);
    if (const double inside = std::min(ends, edges); std::abs(inside) > margin_mm) {
      arrays.coverage[u] = inside > 0 ? 1 : 0;
      continue;
    }
    const double s_per_px = std::abs(here.s_by(ray, rays_.right_of(u, row.v)));
    const double r_per_px = std::abs(here.r_by(ray, rays_.below(u, row.v)));
    arrays.coverage[u] = static_cast<float>(share(ends / s_per_px) * share(edges / r_per_px));
  }
  row.face = {0,
              row.width,
              arrays.x,
              arrays.y,
              arrays.z,
              arrays.normal_x,
              arrays.cos,
              arrays.luf,
              arrays.shift,
              arrays.s,
              arrays.coverage};
  return {0,
          row.width,
          arrays.x,
          arrays.y,
          arrays.z,
          arrays.normal_x,
          arrays.normal_y,
          arrays.normal_z,
          arrays.coverage,
          arrays.light};
}

}  // namespace alltact
