// The layer's thickness varies: t = t0 (1 + share * w(s, y)) with w = 1/2 sum over k = 0..7 of
// cos(2 pi (s cos(a_k) + y sin(a_k)) / length + phase_k), a_k = k pi / 8. These are waves of
// `length_mm` in eight directions with random phases, of mean 0 and variance 1. The outer side
// carries the waves; a press cuts it where it lies.
#include "core/numerics/dispatch.h"
#include "core/numerics/philox.h"
#include "core/numerics/vector_loops.h"
#include "core/simulation/effect.h"

#include <numbers>

namespace alltact {

namespace {

constexpr int kLayerWaves = 8;

struct LayerWave {
  float per_s, per_y, phase;  // turns
};

ALLTACT_WIDE void add_layer_wave(int first, int last, LayerWave wave, const float* __restrict s,
                                 const float* __restrict y, const float* __restrict shift,
                                 float* __restrict sum) {
  for (int u = first; u < last; ++u)
    sum[u] += vector_cos_turns(wave.per_s * s[u] + wave.per_y * (y[u] - shift[u]) + wave.phase);
}

class UnevenLayer final : public GeometryEffect {
 public:
  explicit UnevenLayer(YamlSection& p)
      : share_(p.number("share", strength_up_to(0.1))),
        length_mm_(p.number("length_mm", {0.5, 1000})) {}

  void apply(const FrameContext& frame, FrameGeometry& geometry) const override {
    std::array<LayerWave, kLayerWaves> waves;
    for (std::uint32_t k = 0; k < kLayerWaves; ++k) {
      const double angle = k * std::numbers::pi / kLayerWaves;
      waves[k] = {static_cast<float>(std::cos(angle) / length_mm_),
                  static_cast<float>(std::sin(angle) / length_mm_),
                  static_cast<float>(philox_uniform(frame.seed, "uneven-layer", 0, k))};
    }
    geometry.layer_changes.emplace_back(
        [waves, share = static_cast<float>(share_)](const FaceRow& face, RowScratch& scratch,
                                                    float* luf_mm) {
          float* sum = scratch.floats();
          std::fill(sum + face.first, sum + face.last, 0.0F);
          for (const LayerWave& wave : waves)
            add_layer_wave(face.first, face.last, wave, face.s_mm, face.y_mm, face.shift_mm, sum);
          for (int u = face.first; u < face.last; ++u) luf_mm[u] *= 1.0F + share * 0.5F * sum[u];
        });
  }

 private:
  double share_, length_mm_;
};

}  // namespace

EffectKind effect_uneven_layer() {
  return effect_kind<UnevenLayer>("uneven-layer", 20,
                                  en::say("The layer is not equally thick everywhere"),
                                  "share: 0.03, length_mm: 12");
}

}  // namespace alltact
