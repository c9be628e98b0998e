// White LEDs near the camera: each lights a point by power * cos(incidence) / distance^2, in grey
// levels of a perfectly white surface. A lamp with `aim_mm` shines along the way there, weaker
// beside it by cos^lobe of the angle.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

constexpr Limits kLampPlaceMm{-1e6, 1e6};

struct Lamp {
  float x, y, z, power;
  bool aimed;
  float aim_x, aim_y, aim_z;
  int squarings;  // lobe = 2^squarings
};

ALLTACT_WIDE void shine(const Surface& s, const Lamp& lamp, float* __restrict sum) {
  const float* __restrict x = s.x_mm, * __restrict y = s.y_mm, * __restrict z = s.z_mm;
  const float* __restrict nx = s.normal_x, * __restrict ny = s.normal_y, * __restrict nz = s.normal_z;
  const float lx = lamp.x, ly = lamp.y, lz = lamp.z, power = lamp.power;
  for (int u = s.first; u < s.last; ++u) {
    const float dx = lx - x[u], dy = ly - y[u], dz = lz - z[u];
    const float r2 = dx * dx + dy * dy + dz * dz;
    const float facing = nx[u] * dx + ny[u] * dy + nz[u] * dz;
    sum[u] += power * std::max(facing, 0.0F) / (r2 * std::sqrt(r2));
  }
}

// For a lobe of 2^kSquarings, known when compiled, so that the loop computes that one and no other.
template <int kSquarings>
[[gnu::always_inline]] inline void shine_by_lobe(const Surface& s,
                                                 const Lamp& lamp,
                                                 float* __restrict sum) {
  const float* __restrict x = s.x_mm, * __restrict y = s.y_mm, * __restrict z = s.z_mm;
  const float* __restrict nx = s.normal_x, * __restrict ny = s.normal_y, * __restrict nz = s.normal_z;
  const float lx = lamp.x, ly = lamp.y, lz = lamp.z, power = lamp.power;
  const float ax = lamp.aim_x, ay = lamp.aim_y, az = lamp.aim_z;
  for (int u = s.first; u < s.last; ++u) {
    const float dx = lx - x[u], dy = ly - y[u], dz = lz - z[u];
    const float r2 = dx * dx + dy * dy + dz * dz;
    const float r = std::sqrt(r2);
    const float facing = nx[u] * dx + ny[u] * dy + nz[u] * dz;
    float lobe = std::max(-(ax * dx + ay * dy + az * dz) / r, 0.0F);
    for (int i = 0; i < kSquarings; ++i) lobe *= lobe;
    sum[u] += power * lobe * std::max(facing, 0.0F) / (r2 * r);
  }
}

ALLTACT_WIDE void shine_lobe_1(const Surface& s, const Lamp& lamp, float* __restrict sum) {
  shine_by_lobe<0>(s, lamp, sum);
}
ALLTACT_WIDE void shine_lobe_2(const Surface& s, const Lamp& lamp, float* __restrict sum) {
  shine_by_lobe<1>(s, lamp, sum);
}
ALLTACT_WIDE void shine_lobe_4(const Surface& s, const Lamp& lamp, float* __restrict sum) {
  shine_by_lobe<2>(s, lamp, sum);
}
ALLTACT_WIDE void shine_lobe_8(const Surface& s, const Lamp& lamp, float* __restrict sum) {
  shine_by_lobe<3>(s, lamp, sum);
}

// What a lamp needs and no more: without a lobe none is computed.
void shine_as_aimed(const Surface& s, const Lamp& lamp, float* sum) {
  constexpr std::array kByLobe{shine_lobe_1, shine_lobe_2, shine_lobe_4, shine_lobe_8};
  if (lamp.aimed)
    kByLobe[static_cast<std::size_t>(lamp.squarings)](s, lamp, sum);
  else
    shine(s, lamp, sum);
}

class Leds final : public RadianceEffect {
 public:
  explicit Leds(YamlSection& p) {
    for (YamlSection& section : p.sections("lamps")) lamps_.push_back(read_lamp(section));
    if (lamps_.empty())
      p.refuse("lamps", en::say("there is no lamp"), en::say("- {{at_mm: [x, y, z], power: p}}"));
  }

  Message sentence() const override { return en::say("Lamps light the finger"); }

  std::unique_ptr<const Rows> begin(const FrameContext&, const FrameGeometry&) const override {
    return std::make_unique<LedRows>(*this);
  }

 private:
  class LedRows final : public Rows {
   public:
    explicit LedRows(const Leds& leds) : leds_(leds) {}
    void row(RowView& row) const override {
      float* sum = row.scratch.floats();
      for (const Surface& surface : row.surfaces) {
        std::fill(sum + surface.first, sum + surface.last, 0.0F);
        for (const Lamp& lamp : leds_.lamps_) shine_as_aimed(surface, lamp, sum);
        for (int u = surface.first; u < surface.last; ++u) surface.light[u] *= sum[u];
      }
    }

   private:
    const Leds& leds_;
  };

  static Lamp read_lamp(YamlSection& section) {
    const auto at = section.numbers("at_mm", 3, 3, kLampPlaceMm);
    Lamp lamp{static_cast<float>(at[0]),
              static_cast<float>(at[1]),
              static_cast<float>(at[2]),
              static_cast<float>(section.number("power", strength_up_to(1e9))),
              section.has("aim_mm"),
              0,
              0,
              0,
              0};
    if (!lamp.aimed) return lamp;
    const auto to = section.numbers("aim_mm", 3, 3, kLampPlaceMm);
    const Eigen::Vector3d way(to[0] - at[0], to[1] - at[1], to[2] - at[2]);
    if (way.norm() < 1e-6)
      section.refuse("aim_mm", en::say("the lamp aims at itself"), en::say("another point"));
    const Eigen::Vector3d aim = way.normalized();
    lamp.aim_x = static_cast<float>(aim.x());
    lamp.aim_y = static_cast<float>(aim.y());
    lamp.aim_z = static_cast<float>(aim.z());
    const int lobe = section.whole_number("lobe", 1, 8);
    while (1 << lamp.squarings < lobe) ++lamp.squarings;
    if (1 << lamp.squarings != lobe)
      section.refuse("lobe", en::say("this lobe is not known"), en::say("1, 2, 4 or 8"));
    return lamp;
  }

  std::vector<Lamp> lamps_;
};

}  // namespace

const EffectKind& effect_leds() {
  static const EffectKind kKind{
      "leds", Stage::kRadiance, 50, [](YamlSection& p) -> std::shared_ptr<const Effect> {
        return std::make_shared<Leds>(p);
      }};
  return kKind;
}

}  // namespace alltact
