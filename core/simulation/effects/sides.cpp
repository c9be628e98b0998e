// The two side faces of the finger's body, seen beside the view face: planes y = +-W/2 (shifted
// with a swaying finger), of even albedo, `depth_mm` deep behind the face's edge. What is engraved
// in them is drawn here.
#include "core/simulation/effect.h"

namespace alltact {

namespace {

float part_of(float inside_px) {
  return std::clamp(inside_px + 0.5F, 0.0F, 1.0F);
}

class Sides final : public RadianceEffect {
 public:
  explicit Sides(Parameters& p)
      : albedo_(static_cast<float>(p.number("albedo", {0, 1, true}))),
        depth_mm_(static_cast<float>(p.number("depth_mm", strength_up_to(1000)))) {}

  Status fits(const SceneFacts& scene) const override {
    if (scene.finger.face.kind == FaceKind::kFlat)
      return Error{"a flat sensor has no side faces", "", "leave sides out"};
    if (scene.finger.camera.model == CameraModel::kOrthographic)
      return Error{"an orthographic camera sees no side faces", "", "leave sides out"};
    return {};
  }

  std::unique_ptr<const Rows> begin(const FrameContext&,
                                    const FrameGeometry& geometry) const override {
    return std::make_unique<SideRows>(*this, geometry);
  }

 private:
  class SideRows final : public Rows {
   public:
    SideRows(const Sides& sides, const FrameGeometry& geometry)
        : sides_(sides), geometry_(geometry) {}

    // A ray meets one of the two sides, on the side of the picture's middle where it points. The
    // face's point in the same column tells where along the finger that is.
    void row(RowView& row) const override {
      const int n = row.width;
      Surface side;
      side.first = 0;
      side.last = n;
      float *x = row.scratch.floats(), *y = row.scratch.floats(), *z = row.scratch.floats();
      float *zero = row.scratch.floats(), *inward = row.scratch.floats();
      float *coverage = row.scratch.floats(), *light = row.scratch.floats();
      const FaceRow face = whole_face(row);
      const auto half = static_cast<float>(geometry_.face().width_mm / 2);
      const auto length = static_cast<float>(geometry_.curve()->length_mm());
      for (int u = 0; u < n; ++u) {
        const auto ray = geometry_.rays().at(u, row.v);
        const float y_at_face = ray.direction_y * face.z_mm[u];
        const bool upper = y_at_face < face.shift_mm[u];
        y[u] = face.shift_mm[u] + (upper ? -half : half);
        const float behind = y_at_face == 0 ? 2.0F : y[u] / y_at_face;
        z[u] = face.z_mm[u] * std::clamp(behind, 0.0F, 1.0F);
        x[u] = ray.direction_x * z[u];
        zero[u] = 0;
        inward[u] = upper ? 1.0F : -1.0F;
        light[u] = sides_.albedo_;
        const float back = face.z_mm[u] - z[u];
        const float sin = face.sin_incline[u], cos = face.cos_incline[u];
        const float depth = back * (cos - ray.direction_x * sin);
        const float s = face.s_mm[u] - back * (ray.direction_x * cos + sin);
        const float mm_per_px = z[u] * std::abs(geometry_.rays().step_v(u, row.v).direction_y);
        coverage[u] = behind > 1 || z[u] <= 0
                          ? 0.0F
                          : (1 - face.coverage[u]) *
                                part_of((sides_.depth_mm_ - depth) / mm_per_px) *
                                part_of(s / mm_per_px) * part_of((length - s) / mm_per_px);
        if (z[u] <= 0) z[u] = face.z_mm[u];
      }
      for (const MarkerDisc& disc : geometry_.discs) draw(disc, row.v, light);
      side.x_mm = x;
      side.y_mm = y;
      side.z_mm = z;
      side.normal_x = side.normal_z = zero;
      side.normal_y = inward;
      side.coverage = coverage;
      side.light = light;
      row.surfaces.push_back(side);
    }

   private:
    // The face's row with coverage 0 filled in where the row leaves the face.
    [[nodiscard]] static FaceRow whole_face(RowView& row) {
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

    const Sides& sides_;
    const FrameGeometry& geometry_;
  };

  float albedo_, depth_mm_;
};

}  // namespace

const EffectKind& effect_sides() {
  static const EffectKind kKind{
      "sides", Stage::kRadiance, 20, [](Parameters& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<Sides>(p);
      }};
  return kKind;
}

}  // namespace alltact
