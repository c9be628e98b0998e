// Brightness of the translucent layer over its black coat by Kubelka and Munk: with scattering S
// and absorption K per mm, a layer of thickness t reflects
//   R = sinh(bSt) / (a sinh(bSt) + b cosh(bSt)),  a = (S + K) / S,  b = sqrt(a^2 - 1),
// which without absorption is St / (1 + St). Over a coat that is not black but reflects a share G,
//   R = (1 - G (a - b coth(bSt))) / (a - G + b coth(bSt)),
// without absorption ((1 - G) St + G) / ((1 - G) St + 1).
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/illumination.h"

namespace alltact {

namespace {

constexpr int kTable = 4096;
constexpr double kMaxThickness = 1.5;  // times the undeformed layer: no bulge exceeds it

ALLTACT_WIDE void reflect(int first, int last, float scatter, const float* __restrict thickness,
                          float* __restrict light) {
  for (int u = first; u < last; ++u) {
    const float t = scatter * thickness[u];
    light[u] *= t / (1.0F + t);
  }
}

// Along the normal: `cos` of the face's inclination.
ALLTACT_WIDE void reflect_by_normal(int first, int last, float scatter, const float* __restrict luf,
                                    const float* __restrict cos, float* __restrict light) {
  for (int u = first; u < last; ++u) {
    const float t = scatter * (luf[u] * cos[u]);
    light[u] *= t / (1.0F + t);
  }
}

ALLTACT_WIDE void reflect_over_coat(int first, int last, float scatter, float coat,
                                    const float* __restrict thickness, float* __restrict light) {
  for (int u = first; u < last; ++u) {
    const float t = (1.0F - coat) * scatter * thickness[u];
    light[u] *= (t + coat) / (t + 1.0F);
  }
}

class Layer final : public RadianceEffect {
 public:
  explicit Layer(YamlSection& p)
      : optics_{p.number("scatter_per_mm", strength_up_to(100)),
                p.number_or("absorb_per_mm", 0, strength_up_to(100)),
                p.number_or("coat", 0, {0, 1, true, true, true})},
        along_z_(p.choice("along", {"normal", "z"}) == 1) {}

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    if (optics_.absorb_per_mm == 0) return [this](RowView& row) { scatter(row); };
    // By table, within 1e-7 of the formula.
    const double max_thickness_mm = kMaxThickness * geometry.max_thickness_mm();
    std::vector<float> table;
    for (int i = 0; i <= kTable; ++i)
      table.push_back(static_cast<float>(optics_.reflectance(max_thickness_mm * i / kTable)));
    const auto per_mm = static_cast<float>(kTable / max_thickness_mm);
    return [this, table = std::move(table), per_mm](RowView& row) {
      const float* thick = thickness(row);
      for (int u = row.face.first; u < row.face.last; ++u) {
        const float at = std::min(thick[u] * per_mm, static_cast<float>(kTable) - 0.001F);
        const auto i = static_cast<std::size_t>(at);
        const float part = at - static_cast<float>(i);
        row.surfaces[0].light[u] *= table[i] + part * (table[i + 1] - table[i]);
      }
    };
  }

 private:
  // The layer's thickness in each pixel of the row.
  [[nodiscard]] const float* thickness(RowView& row) const {
    const FaceRow& face = row.face;
    float* thickness = row.scratch.floats();
    std::copy(face.luf_mm + face.first, face.luf_mm + face.last, thickness + face.first);
    for (int u = row.press_first; u < row.press_last; ++u)
      thickness[u] = std::max(0.0F, thickness[u] - row.press_depth_mm[u]);
    if (row.hollow_mm)
      for (int u = face.first; u < face.last; ++u)
        thickness[u] = std::max(0.0F, thickness[u] - row.hollow_mm[u] / face.cos_incline[u]);
    if (!along_z_)
      for (int u = face.first; u < face.last; ++u) thickness[u] *= face.cos_incline[u];
    return thickness;
  }

  void scatter(RowView& row) const {
    const FaceRow& face = row.face;
    const auto per_mm = static_cast<float>(optics_.scatter_per_mm);
    const auto coat = static_cast<float>(optics_.coat);
    const bool is_changed = row.press_first < row.press_last || row.hollow_mm;
    float* light = row.surfaces[0].light;
    if (coat > 0)
      reflect_over_coat(face.first, face.last, per_mm, coat, thickness(row), light);
    else if (is_changed)
      reflect(face.first, face.last, per_mm, thickness(row), light);
    else if (along_z_)
      reflect(face.first, face.last, per_mm, face.luf_mm, light);
    else
      reflect_by_normal(face.first, face.last, per_mm, face.luf_mm, face.cos_incline, light);
  }

  LayerOptics optics_;
  bool along_z_;
};

}  // namespace

EffectKind effect_layer() {
  return effect_kind<Layer>("layer", 10,
                            en::say("The layer over the black coat is darker where it is thinner"),
                            "scatter_per_mm: 0.6, along: normal");
}

}  // namespace alltact
