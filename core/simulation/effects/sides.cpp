// The two side faces of the finger's body, next to the view face in the image: planes y = +-W/2 of
// uniform albedo, `depth_mm` deep behind the face's edge. They shift with a swaying finger; on a
// twisting one the section's edges sweep them. Engraved dots are drawn here.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/ruled_surface.h"

namespace alltact {

namespace {

inline float unit(float part) { return std::min(std::max(part, 0.0F), 1.0F); }

// Input and output of the loop below.
struct SideRow {
  int n;
  float half_width, length, depth, albedo;
  RayRow rays;
  FaceRow face;
  float *x, *y, *z, *normal_x, *inward, *normal_z, *coverage, *light;
};

ALLTACT_WIDE void intersect_sides(const SideRow& r) {
  const float* __restrict dx = r.rays.direction_x, * __restrict dy = r.rays.direction_y;
  const float* __restrict step = r.rays.step_y;
  const float* __restrict face_z = r.face.z_mm, * __restrict shift = r.face.shift_mm;
  const float* __restrict sin = r.face.sin_incline, * __restrict cos = r.face.cos_incline;
  const float* __restrict face_s = r.face.s_mm, * __restrict face_part = r.face.coverage;
  float* __restrict x = r.x, * __restrict y = r.y, * __restrict z = r.z;
  float* __restrict inward = r.inward, * __restrict coverage = r.coverage;
  float* __restrict light = r.light;
  const float half = r.half_width, length = r.length, deep = r.depth, albedo = r.albedo;
  const int n = r.n;
#pragma GCC ivdep  // the arrays are rows of their own
  for (int u = 0; u < n; ++u) {
    // The ray points to one of the sides and intersects it at this fraction of its path to the
    // face.
    const float y_at_face = dy[u] * face_z[u];
    const float towards = y_at_face < shift[u] ? -1.0F : 1.0F;
    y[u] = shift[u] + towards * half;
    const float hit_fraction = (half + towards * shift[u]) / std::max(y_at_face * towards, 1e-6F);
    const float share = std::min(std::max(hit_fraction, 0.01F), 1.0F);
    z[u] = face_z[u] * share;
    x[u] = dx[u] * z[u];
    inward[u] = -towards;
    light[u] = albedo;
    // The depth behind the face, and the position along it, follow from the column's point of the
    // face.
    const float back = face_z[u] - z[u];
    const float behind = back * (cos[u] - dx[u] * sin[u]);
    const float s = face_s[u] - back * (dx[u] * cos[u] + sin[u]);
    const float per_mm = 1.0F / (z[u] * step[u]);
    coverage[u] = (1.0F - face_part[u]) * unit((deep - behind) * per_mm + 0.5F) *
                  unit(s * per_mm + 0.5F) * unit((length - s) * per_mm + 0.5F);
  }
}

// Intersects each ray with the side that it points to.
void intersect_sides_by_rays(const SideRow& r, const FrameGeometry& geometry, int v) {
  const auto n = static_cast<std::size_t>(r.n);
  std::vector<Ray> rays(n);
  std::vector<char> at_upper(n, 0), at_lower(n, 0);
  for (int u = 0; u < r.n; ++u) {
    r.light[u] = r.albedo;
    r.x[u] = r.y[u] = r.coverage[u] = r.normal_x[u] = r.inward[u] = 0;
    r.z[u] = r.normal_z[u] = 1;
    if (r.face.coverage[u] >= 1 || r.face.s_mm[u] == kNoHit_mm) continue;
    const auto i = static_cast<std::size_t>(u);
    rays[i] = geometry.rays().ray(u, v);
    (r.face.y_mm[u] < r.face.shift_mm[u] ? at_upper : at_lower)[i] = 1;
  }
  const double width_mm = 2 * r.half_width;
  const auto upper = RuledSurface::side_face(*geometry.curve(), -1, width_mm)
                         .intersect_row(rays, at_upper, r.face.s_mm);
  const auto lower = RuledSurface::side_face(*geometry.curve(), 1, width_mm)
                         .intersect_row(rays, at_lower, r.face.s_mm);
  for (int u = 0; u < r.n; ++u) {
    const auto i = static_cast<std::size_t>(u);
    const bool is_upper = at_upper[i] != 0;
    const RuledSurface::IntersectionRow& side = is_upper ? upper : lower;
    if (!side.is_hit(i)) continue;
    const RuledSurface::Intersection here = side.at(i);
    const auto s = static_cast<float>(here.s_mm), behind = static_cast<float>(here.r_mm);
    const double off_mm = std::max({behind - r.depth, -s, s - r.length});
    if (off_mm > kEdgeMargin_px * geometry.rays().camera().mm_per_px_at(here.z_mm)) continue;
    const Ray& ray = rays[i];
    const Eigen::Vector3d point = ray.point_at(here.z_mm);
    const Eigen::Vector3d inward = is_upper ? here.normal : Eigen::Vector3d(-here.normal);
    if (inward.dot(ray.direction) >= 0) continue;  // viewed from outside
    r.x[u] = static_cast<float>(point.x());
    r.y[u] = static_cast<float>(point.y());
    r.z[u] = static_cast<float>(point.z());
    r.normal_x[u] = static_cast<float>(inward.x());
    r.inward[u] = static_cast<float>(inward.y());
    r.normal_z[u] = static_cast<float>(inward.z());
    const Ray right_of = geometry.rays().right_of(u, v), below = geometry.rays().below(u, v);
    const auto s_px = static_cast<float>(std::abs(here.s_by(ray, right_of)));
    const auto r_px = static_cast<float>(std::abs(here.r_by(ray, below)));
    r.coverage[u] = (1.0F - r.face.coverage[u]) * unit((r.depth - behind) / r_px + 0.5F) *
                    unit(s / s_px + 0.5F) * unit((r.length - s) / s_px + 0.5F);
  }
}

class Sides final : public RadianceEffect {
 public:
  explicit Sides(YamlSection& p)
      : albedo_(static_cast<float>(p.number("albedo", strength_up_to(1)))),
        depth_mm_(static_cast<float>(p.number("depth_mm", strength_up_to(1000)))) {}

  Status validate(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{en::say("a flat sensor has no side faces"), "", en::say("leave sides out")};
    if (scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{en::say("an orthographic camera sees no side faces"), "",
                   en::say("leave sides out")};
    return {};
  }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    return [this, &geometry](RowView& row) { add_sides(geometry, row); };
  }

 private:
  void add_sides(const FrameGeometry& geometry, RowView& row) const {
    const auto floats = [&] { return row.scratch.floats(); };
    const SideRow r{row.width,
                    static_cast<float>(geometry.face().width_mm / 2),
                    static_cast<float>(geometry.curve()->length_mm()),
                    depth_mm_,
                    albedo_,
                    geometry.rays().row(row.v, row.scratch),
                    full_face(row),
                    floats(),
                    floats(),
                    floats(),
                    floats(),
                    floats(),
                    floats(),
                    floats(),
                    floats()};
    if (geometry.is_column_wise()) {
      std::fill(r.normal_x, r.normal_x + r.n, 0.0F);
      std::fill(r.normal_z, r.normal_z + r.n, 0.0F);
      intersect_sides(r);
    } else {
      intersect_sides_by_rays(r, geometry, row.v);
    }
    for (const MarkerDisc& disc : geometry.discs) draw(disc, row.v, r.light);
    row.surfaces.push_back(
        {0, row.width, r.x, r.y, r.z, r.normal_x, r.inward, r.normal_z, r.coverage, r.light});
  }

  // The face's row, with coverage 0 where the row is off the face.
  [[nodiscard]] static FaceRow full_face(RowView& row) {
    FaceRow face = row.face;
    float* coverage = row.scratch.floats();
    std::fill(coverage, coverage + row.width, 0.0F);
    std::copy(face.coverage + face.first, face.coverage + face.last, coverage + face.first);
    face.coverage = coverage;
    return face;
  }

  static void draw(const MarkerDisc& disc, int v, float* light) {
    const int row = v - disc.corner.y;
    if (!disc.visible || row < 0 || row >= disc.coverage.rows) return;
    for (int i = 0; i < disc.coverage.cols; ++i) {
      float& here = light[disc.corner.x + i];
      here += disc.coverage(row, i) * (static_cast<float>(disc.albedo) - here);
    }
  }

  float albedo_, depth_mm_;
};

}  // namespace

EffectKind effect_sides() {
  return effect_kind<Sides>("sides", 20, en::say("The side faces of the body are visible"),
                            "albedo: 0.12, depth_mm: 14");
}

}  // namespace alltact
