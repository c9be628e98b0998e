// Specular reflection of a lamp in the view face: light += level * max(0, h . n)^sharpness, h
// halfway between the directions to the lamp and to the camera, n the face's normal (J. Blinn,
// SIGGRAPH 1977).
#include "core/numerics/dispatch.h"
#include "core/numerics/vector_loops.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

struct GlareLamp {
  float x, y, z, level, sharpness;
  float spread;  // 0 for an orthographic camera, whose rays run along z, else 1
};

ALLTACT_WIDE void add_glare(const Surface& s, GlareLamp lamp) {
  const float* __restrict x = s.x_mm, * __restrict y = s.y_mm, * __restrict z = s.z_mm;
  const float* __restrict nx = s.normal_x, * __restrict ny = s.normal_y, * __restrict nz = s.normal_z;
  float* __restrict light = s.light;
  for (int u = s.first; u < s.last; ++u) {
    const float lx = lamp.x - x[u], ly = lamp.y - y[u], lz = lamp.z - z[u];
    const float cx = -lamp.spread * x[u], cy = -lamp.spread * y[u], cz = -z[u];
    const float l = std::sqrt(lx * lx + ly * ly + lz * lz);
    const float c = std::sqrt(cx * cx + cy * cy + cz * cz);
    const float hx = lx * c + cx * l, hy = ly * c + cy * l, hz = lz * c + cz * l;
    const float h = std::sqrt(hx * hx + hy * hy + hz * hz);
    const float facing = (nx[u] * hx + ny[u] * hy + nz[u] * hz) / std::max(h, 1e-12F);
    light[u] += lamp.level * vector_pow(facing, lamp.sharpness);
  }
}

class Glare final : public RadianceEffect {
 public:
  explicit Glare(YamlSection& p) {
    const auto at = p.numbers("at_mm", 3, 3, {-1e6, 1e6});
    lamp_ = {static_cast<float>(at[0]),
             static_cast<float>(at[1]),
             static_cast<float>(at[2]),
             static_cast<float>(p.number("level", strength_up_to(1e6))),
             static_cast<float>(p.number("sharpness", {1, 10000})),
             1};
  }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    GlareLamp lamp = lamp_;
    if (!geometry.rays().camera().is_perspective()) lamp.spread = 0;
    return [lamp](RowView& row) { add_glare(row.surfaces[0], lamp); };
  }

 private:
  GlareLamp lamp_{};
};

}  // namespace

EffectKind effect_glare() {
  return effect_kind<Glare>("glare", 60, en::say("The face reflects a lamp"),
                            "at_mm: [60, 0, 20], level: 80, sharpness: 64");
}

}  // namespace alltact
