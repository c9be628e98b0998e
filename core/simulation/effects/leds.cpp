// White LEDs near the camera: each lights a point by power * cos(incidence) / distance^2, in grey
// levels of a perfectly white surface. A lamp with `aim_mm` shines along the way there, weaker
// beside it by cos^lobe of the angle. What other effects do to the lamps and to their light stands
// in the frame's Illumination.
#include "core/numerics/dispatch.h"
#include "core/simulation/effect.h"
#include "core/simulation/vector_math.h"

namespace alltact {

namespace {

constexpr int kPartOfRow = 256;  // pixels for which lamp after lamp shines from the nearest cache
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

// What is left of the light of one lamp on its way through the clear body to the surface and on to
// the camera. `spread` is 0 for an orthographic camera, whose rays run along z, else 1.
ALLTACT_WIDE void absorb_on_the_way(const Surface& s,
                                    const Lamp& lamp,
                                    float per_mm,
                                    float spread,
                                    const float* __restrict light,
                                    float* __restrict sum) {
  const float* __restrict x = s.x_mm, * __restrict y = s.y_mm, * __restrict z = s.z_mm;
  const float lx = lamp.x, ly = lamp.y, lz = lamp.z;
  for (int u = s.first; u < s.last; ++u) {
    const float dx = lx - x[u], dy = ly - y[u], dz = lz - z[u];
    const float there = std::sqrt(dx * dx + dy * dy + dz * dz);
    const float back = std::sqrt(spread * (x[u] * x[u] + y[u] * y[u]) + z[u] * z[u]);
    sum[u] += light[u] * vector_exp(-per_mm * (there + back));
  }
}

ALLTACT_WIDE void set_level(const Surface& s, float level, float* __restrict sum) {
  for (int u = s.first; u < s.last; ++u) sum[u] = level;
}

ALLTACT_WIDE void light_up(const Surface& s, const float* __restrict sum) {
  float* __restrict light = s.light;
  for (int u = s.first; u < s.last; ++u) light[u] *= sum[u];
}

class Leds final : public RadianceEffect {
 public:
  explicit Leds(YamlSection& p) {
    for (YamlSection& section : p.sections("lamps")) lamps_.push_back(read_lamp(section));
    if (lamps_.empty())
      p.refuse("lamps", en::say("there is no lamp"), en::say("- {{at_mm: [x, y, z], power: p}}"));
  }

  Message sentence() const override { return en::say("Lamps light the finger"); }

  int lamp_count() const override { return static_cast<int>(lamps_.size()); }

  std::unique_ptr<const Rows> begin(const FrameContext&,
                                    const FrameGeometry& geometry) const override {
    const Illumination& now = geometry.illumination;
    std::vector<Lamp> lamps = lamps_;
    for (std::size_t i = 0; i < lamps.size(); ++i)
      lamps[i].power *= static_cast<float>(now.share_of(static_cast<int>(i)));
    return std::make_unique<LedRows>(
        std::move(lamps), now, geometry.rays().camera().is_perspective());
  }

 private:
  class LedRows final : public Rows {
   public:
    LedRows(std::vector<Lamp> lamps, const Illumination& now, bool perspective)
        : lamps_(std::move(lamps)),
          room_level_(static_cast<float>(now.room_level)),
          absorb_per_mm_(static_cast<float>(now.absorb_per_mm)),
          spread_(perspective ? 1.0F : 0.0F) {}

    void row(RowView& row) const override {
      float* sum = row.scratch.floats();
      float* one = absorb_per_mm_ > 0 ? row.scratch.floats() : nullptr;
      for (const Surface& surface : row.surfaces)
        for (Surface part = surface; part.first < surface.last; part.first = part.last) {
          part.last = std::min(part.first + kPartOfRow, surface.last);
          light_part(part, sum, one);
        }
    }

   private:
    void light_part(const Surface& part, float* sum, float* one) const {
      set_level(part, room_level_, sum);
      for (const Lamp& lamp : lamps_) {
        if (!one) {
          shine_as_aimed(part, lamp, sum);
          continue;
        }
        std::fill(one + part.first, one + part.last, 0.0F);
        shine_as_aimed(part, lamp, one);
        absorb_on_the_way(part, lamp, absorb_per_mm_, spread_, one, sum);
      }
      light_up(part, sum);
    }

    std::vector<Lamp> lamps_;
    float room_level_, absorb_per_mm_, spread_;
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
      "leds",
      Stage::kRadiance,
      50,
      [](YamlSection& p) -> std::shared_ptr<const Effect> { return std::make_shared<Leds>(p); },
      "lamps: [{at_mm: [0, 3, 0], power: 540000}, {at_mm: [4, 0, -20], power: 3300000, "
      "aim_mm: [71, 0, 93], lobe: 8}]"};
  return kKind;
}

}  // namespace alltact
