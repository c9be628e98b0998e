// The image darkens towards its corners. `kind: cos4`: V = cos^4 of the angle between the pixel's
// ray and the axis, the natural fall-off of a simple lens (M. Reiss, "The cos^4 law of
// illumination", JOSA 35, 1945). `kind: polynomial`: V = 1 + a r^2 + b r^4 + c r^6, r the distance
// from the principal point as a share of the farthest corner's, coefficients: [a, b, c] (Goldman,
// "Vignette and exposure calibration and compensation", TPAMI 32, 2010).
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

constexpr int kVignettingSteps = 1000;  // samples at which a polynomial must be above 0

ALLTACT_WIDE void vignette_cos4(int n, const float* __restrict dx, const float* __restrict dy,
                                float* __restrict share) {
  for (int u = 0; u < n; ++u) {
    const float cos2 = 1.0F / (1.0F + dx[u] * dx[u] + dy[u] * dy[u]);
    share[u] = cos2 * cos2;
  }
}

struct VignettingPolynomial {
  float a, b, c;
};

ALLTACT_WIDE void vignette_polynomial(int n, float cx, float y2, float per_r2,
                                      VignettingPolynomial p, float* __restrict share) {
  const float a = p.a, b = p.b, c = p.c;
  for (int u = 0; u < n; ++u) {
    const float x = static_cast<float>(u) - cx;
    const float r2 = (x * x + y2) * per_r2;
    share[u] = 1.0F + r2 * (a + r2 * (b + r2 * c));
  }
}

class Vignetting final : public RadianceEffect {
 public:
  explicit Vignetting(YamlSection& p) : cos4_(p.choice("kind", {"cos4", "polynomial"}) == 0) {
    if (cos4_) return;
    std::vector<double> k = p.numbers("coefficients", 1, 3, {-10, 10});
    k.resize(3);
    for (int i = 1; i <= kVignettingSteps; ++i) {
      const double r2 = static_cast<double>(i) / kVignettingSteps;
      if (1 + r2 * (k[0] + r2 * (k[1] + r2 * k[2])) <= 0)
        p.refuse("coefficients", en::say("parts of the image would have no light"),
                 en::say("1 + a r^2 + b r^4 + c r^6 above 0 up to r = 1"));
    }
    polynomial_ = {static_cast<float>(k[0]), static_cast<float>(k[1]), static_cast<float>(k[2])};
  }

  Status validate(const SceneFacts& scene) const override {
    if (cos4_ && scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{en::say("the rays of an orthographic camera do not spread"), "",
                   en::say("kind: polynomial, or leave vignetting out")};
    return {};
  }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    const PixelRays& rays = geometry.rays();
    if (cos4_)
      return [&rays](RowView& row) {
        float* share = row.scratch.floats();
        const RayRow ray = rays.row(row.v, row.scratch);
        vignette_cos4(row.width, ray.direction_x, ray.direction_y, share);
        apply(share, row);
      };
    const CameraParameters& camera = rays.camera().parameters();
    const double x = std::max(camera.cx_px, camera.width_px - 1 - camera.cx_px);
    const double y = std::max(camera.cy_px, camera.height_px - 1 - camera.cy_px);
    return [this, &camera, per_r2 = static_cast<float>(1 / (x * x + y * y))](RowView& row) {
      float* share = row.scratch.floats();
      const double from_middle = row.v - camera.cy_px;
      vignette_polynomial(row.width, static_cast<float>(camera.cx_px),
                          static_cast<float>(from_middle * from_middle), per_r2, polynomial_,
                          share);
      apply(share, row);
    };
  }

 private:
  static void apply(const float* share, RowView& row) {
    for (const Surface& surface : row.surfaces)
      for (int u = surface.first; u < surface.last; ++u) surface.light[u] *= share[u];
  }

  bool cos4_;
  VignettingPolynomial polynomial_{};
};

}  // namespace

EffectKind effect_vignetting() {
  return effect_kind<Vignetting>("vignetting", 90,
                                 en::say("The image is darker towards its corners"), "kind: cos4");
}

}  // namespace alltact
