#include "core/simulation/frame_geometry.h"
#include "core/simulation/ruled_surface.h"

#include <array>

namespace alltact {

namespace {

// So far within its edges a pixel is all face, however slanted.
constexpr double kSurePixels = 50;

// Where the next pixel of a row will meet the face: along the parabola through the last three.
class NextMeeting {
 public:
  [[nodiscard]] std::optional<double> s_mm() const {
    switch (count_) {
      case 0:
        return std::nullopt;
      case 1:
        return last_[0];
      case 2:
        return 2 * last_[0] - last_[1];
      default:
        return 3 * (last_[0] - last_[1]) + last_[2];
    }
  }
  void add(double s_mm) {
    last_ = {s_mm, last_[0], last_[1]};
    count_ = std::min(count_ + 1, 3);
  }
  void forget() { count_ = 0; }

 private:
  std::array<double, 3> last_{};
  int count_ = 0;
};

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
  NextMeeting next;
  for (int u = 0; u < row.width; ++u) {
    const Ray ray = rays_.ray(u, row.v);
    if (!curve_) {
      met.set(u, ray.point_at(face_.plane_z_mm), Eigen::Vector3d::UnitZ());
      met.luf[u] = static_cast<float>(face_.layer_mm);
      met.s[u] = met.x[u];
      met.shift[u] = 0;
      met.coverage[u] = 1;
      continue;
    }
    const RuledSurface face = RuledSurface::view_face(*curve_);
    std::optional<RuledSurface::Meeting> here;
    if (const auto near = next.s_mm()) here = face.meet(ray, *near);
    if (!here) here = face.meet(ray);
    if (!here) {
      met.miss(u);
      next.forget();
      continue;
    }
    next.add(here->s_mm);
    met.set(u, ray.point_at(here->z_mm), here->normal);
    met.luf[u] = static_cast<float>(face_.layer_mm / here->normal.z());
    met.s[u] = static_cast<float>(here->s_mm);
    met.shift[u] = met.y[u] - static_cast<float>(here->r_mm);
    const double ends = std::min(here->s_mm, curve_->length_mm() - here->s_mm);
    const double edges = face_.width_mm / 2 - std::abs(here->r_mm);
    const double sure_mm = kSurePixels * rays_.camera().mm_per_px_at(here->z_mm);
    if (std::min(ends, edges) > sure_mm) {
      met.coverage[u] = 1;
      continue;
    }
    const double s_per_px = std::abs(here->s_by(ray, rays_.beside(u, row.v)));
    const double r_per_px = std::abs(here->r_by(ray, rays_.below(u, row.v)));
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
