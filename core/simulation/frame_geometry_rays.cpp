#include "core/simulation/frame_geometry.h"
#include "core/simulation/ruled_surface.h"

namespace alltact {

namespace {

// The face's row in the making.
struct MetRow {
  explicit MetRow(RowScratch& scratch) {
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
  // Nothing is seen; the numbers only have to be finite.
  void miss(int u) {
    set(u, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ());
    luf[u] = 1;
    s[u] = kNotMet_mm;
    shift[u] = coverage[u] = 0;
  }
};

double share(double inside_px) {
  return std::clamp(inside_px + 0.5, 0.0, 1.0);
}

}  // namespace

Surface FrameGeometry::fill_by_rays(RowView& row) const {
  MetRow met(row.scratch);
  const auto n = static_cast<std::size_t>(row.width);
  std::vector<Ray> rays(n);
  for (int u = 0; u < row.width; ++u) rays[static_cast<std::size_t>(u)] = rays_.ray(u, row.v);
  std::optional<RuledSurface::MeetingRow> meetings;
  if (curve_) meetings = RuledSurface::view_face(*curve_).meet_row(rays, std::vector<char>(n, 1));
  for (int u = 0; u < row.width; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const Ray& ray = rays[i];
    if (!meetings) {
      met.set(u, ray.point_at(face_.plane_z_mm), Eigen::Vector3d::UnitZ());
      met.luf[u] = static_cast<float>(face_.layer_mm);
      met.s[u] = met.x[u];
      met.shift[u] = 0;
      met.coverage[u] = 1;
      continue;
    }
    if (!meetings->met(i)) {
      met.miss(u);
      continue;
    }
    const RuledSurface::Meeting here = meetings->at(i);
    met.set(u, ray.point_at(here.z_mm), here.normal);
    met.luf[u] = static_cast<float>(face_.layer_mm / here.normal.z());
    met.s[u] = static_cast<float>(here.s_mm);
    met.shift[u] = met.y[u] - static_cast<float>(here.r_mm);
    const double ends = std::min(here.s_mm, curve_->length_mm() - here.s_mm);
    const double edges = face_.width_mm / 2 - std::abs(here.r_mm);
    const double sure_mm = kSurePixels * rays_.camera().mm_per_px_at(here.z_mm);
    if (const double inside = std::min(ends, edges); std::abs(inside) > sure_mm) {
      met.coverage[u] = inside > 0 ? 1 : 0;
      continue;
    }
    const double s_per_px = std::abs(here.s_by(ray, rays_.beside(u, row.v)));
    const double r_per_px = std::abs(here.r_by(ray, rays_.below(u, row.v)));
    met.coverage[u] = static_cast<float>(share(ends / s_per_px) * share(edges / r_per_px));
  }
  row.face = {0,
              row.width,
              met.x,
              met.y,
              met.z,
              met.normal_x,
              met.cos,
              met.luf,
              met.shift,
              met.s,
              met.coverage};
  return {0,
          row.width,
          met.x,
          met.y,
          met.z,
          met.normal_x,
          met.normal_y,
          met.normal_z,
          met.coverage,
          met.light};
}

}  // namespace alltact
