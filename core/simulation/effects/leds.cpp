// White LEDs near the camera: each lights a point by power * cos(incidence) / distance^2, in grey
// levels of a perfectly white surface. A lamp with `aim_mm` shines towards that point and falls off
// by cos^lobe of the angle to it. The frame's Illumination holds what other effects do to lamps and
// light.
#include "core/numerics/dispatch.h"
#include "core/numerics/vector_loops.h"
#include "core/simulation/effect.h"

namespace alltact {

namespace {

constexpr Limits kLampPositionMm{-1e6, 1e6};

struct Lamp {
  float x, y, z, power;
  bool aimed;
  float aim_x, aim_y, aim_z;
  int squarings;  // lobe = 2^squarings
};

// Pixels of a row that all lamps light in turn, few enough to stay in the L1 cache.
constexpr int kRowChunk = 256;
struct RowChunk {
  int n;
  const float *x, *y, *z, *nx, *ny, *nz;
};

// Adds the light of a lamp without a lobe, or with one of 2^kSquarings. The count is a template
// argument, so that the loop computes only that lobe.
constexpr int kNoLobe = -1;
template <int kSquarings>
[[gnu::always_inline]] inline void shine(const RowChunk& p, const Lamp& lamp,
                                         float* __restrict sum) {
  const float* __restrict x = p.x, * __restrict y = p.y, * __restrict z = p.z;
  const float* __restrict nx = p.nx, * __restrict ny = p.ny, * __restrict nz = p.nz;
  const float lx = lamp.x, ly = lamp.y, lz = lamp.z, power = lamp.power;
  const float ax = lamp.aim_x, ay = lamp.aim_y, az = lamp.aim_z;
  for (int u = 0; u < p.n; ++u) {
    const float dx = lx - x[u], dy = ly - y[u], dz = lz - z[u];
    const float r2 = dx * dx + dy * dy + dz * dz;
    const float r = std::sqrt(r2);
    const float facing = nx[u] * dx + ny[u] * dy + nz[u] * dz;
    if constexpr (kSquarings == kNoLobe) {
      sum[u] += power * std::max(facing, 0.0F) / (r2 * r);
    } else {
      float lobe = std::max(-(ax * dx + ay * dy + az * dz) / r, 0.0F);
      for (int i = 0; i < kSquarings; ++i) lobe *= lobe;
      sum[u] += power * lobe * std::max(facing, 0.0F) / (r2 * r);
    }
  }
}

[[gnu::always_inline]] inline void shine_as_aimed(const RowChunk& p, const Lamp& lamp,
                                                  float* __restrict sum) {
  if (!lamp.aimed) return shine<kNoLobe>(p, lamp, sum);
  switch (lamp.squarings) {
    case 0:
      return shine<0>(p, lamp, sum);
    case 1:
      return shine<1>(p, lamp, sum);
    case 2:
      return shine<2>(p, lamp, sum);
    default:
      return shine<3>(p, lamp, sum);
  }
}

// Attenuates the light of one lamp along its path through the clear body to the surface and on to
// the camera. `spread` is 0 for an orthographic camera, whose rays run along z, else 1. `back_part`
// is 0 for the path to the surface alone, else 1.
[[gnu::always_inline]] inline void absorb_on_path(const RowChunk& p, const Lamp& lamp, float per_mm,
                                                  float spread, float back_part,
                                                  const float* __restrict light,
                                                  float* __restrict sum) {
  const float* __restrict x = p.x, * __restrict y = p.y, * __restrict z = p.z;
  const float lx = lamp.x, ly = lamp.y, lz = lamp.z;
  for (int u = 0; u < p.n; ++u) {
    const float dx = lx - x[u], dy = ly - y[u], dz = lz - z[u];
    const float there = std::sqrt(dx * dx + dy * dy + dz * dz);
    const float back = std::sqrt(spread * (x[u] * x[u] + y[u] * y[u]) + z[u] * z[u]);
    sum[u] += light[u] * vector_exp(-per_mm * (there + back_part * back));
  }
}

// Attenuates light at the surface along its path to the camera.
[[gnu::always_inline]] inline void absorb_on_return(const RowChunk& p, float per_mm, float spread,
                                                    const float* __restrict light,
                                                    float* __restrict sum) {
  const float* __restrict x = p.x, * __restrict y = p.y, * __restrict z = p.z;
  for (int u = 0; u < p.n; ++u) {
    const float back = std::sqrt(spread * (x[u] * x[u] + y[u] * y[u]) + z[u] * z[u]);
    sum[u] += light[u] * vector_exp(-per_mm * back);
  }
}

// All lamps in one frame.
struct Lamps {
  std::vector<Lamp> lamps;
  float room_level, absorb_per_mm;
  float spread;
};

RowChunk chunk_of(const Surface& s, int first) {
  return {std::min(kRowChunk, s.last - first),
          s.x_mm + first,
          s.y_mm + first,
          s.z_mm + first,
          s.normal_x + first,
          s.normal_y + first,
          s.normal_z + first};
}

// Room and lamps. `one`: buffer for the light of one lamp.
[[gnu::always_inline]] inline void shine_all(const RowChunk& p, const Lamps& all, float back_part,
                                             float* one, float* sum) {
  for (int i = 0; i < p.n; ++i) sum[i] = all.room_level;
  for (const Lamp& lamp : all.lamps) {
    if (all.absorb_per_mm == 0) {
      shine_as_aimed(p, lamp, sum);
      continue;
    }
    for (int i = 0; i < p.n; ++i) one[i] = 0;
    shine_as_aimed(p, lamp, one);
    absorb_on_path(p, lamp, all.absorb_per_mm, all.spread, back_part, one, sum);
  }
}

// `indirect`: additional light at the surface, by column; null: none.
ALLTACT_WIDE void light_up(const Surface& s, const Lamps& all, const float* indirect) {
  alignas(64) float sum[kRowChunk], one[kRowChunk];
  for (int first = s.first; first < s.last; first += kRowChunk) {
    const RowChunk p = chunk_of(s, first);
    shine_all(p, all, 1, one, sum);
    if (indirect && all.absorb_per_mm > 0) {
      absorb_on_return(p, all.absorb_per_mm, all.spread, indirect + first, sum);
    } else if (indirect) {
      for (int i = 0; i < p.n; ++i) sum[i] += indirect[first + i];
    }
    float* __restrict light = s.light + first;
    for (int i = 0; i < p.n; ++i) light[i] *= sum[i];
  }
}

// Irradiance directly from the lamps and the room.
ALLTACT_WIDE void irradiate(const Surface& s, const Lamps& all, float* irradiance) {
  alignas(64) float one[kRowChunk];
  for (int first = s.first; first < s.last; first += kRowChunk)
    shine_all(chunk_of(s, first), all, 0, one, irradiance + first);
}

class Leds final : public RadianceEffect {
 public:
  explicit Leds(YamlSection& p) {
    for (YamlSection& section : p.sections("lamps")) lamps_.push_back(read_lamp(section));
    if (lamps_.empty())
      p.refuse("lamps", en::say("there is no lamp"), en::say("- {{at_mm: [x, y, z], power: p}}"));
  }

  int lamp_count() const override { return static_cast<int>(lamps_.size()); }

  Rows begin(const FrameContext&, const FrameGeometry& geometry) const override {
    const Illumination& now = geometry.illumination;
    std::vector<Lamp> lamps = lamps_;
    for (std::size_t i = 0; i < lamps.size(); ++i)
      lamps[i].power *= static_cast<float>(now.share_of(static_cast<int>(i)));
    Lamps all{std::move(lamps), static_cast<float>(now.room_level),
              static_cast<float>(now.absorb_per_mm),
              geometry.rays().camera().is_perspective() ? 1.0F : 0.0F};
    if (!now.indirect)
      return [all = std::move(all)](RowView& row) {
        for (const Surface& surface : row.surfaces) light_up(surface, all, nullptr);
      };
    IndirectRows set_indirect = now.indirect(
        [&](const Surface& surface, float* irradiance) { irradiate(surface, all, irradiance); });
    return [all = std::move(all), set_indirect = std::move(set_indirect)](RowView& row) {
      float* indirect = row.scratch.floats();
      for (const Surface& surface : row.surfaces) {
        set_indirect(row, surface, indirect);
        light_up(surface, all, indirect);
      }
    };
  }

 private:
  static Lamp read_lamp(YamlSection& section) {
    const auto at = section.numbers("at_mm", 3, 3, kLampPositionMm);
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
    const auto to = section.numbers("aim_mm", 3, 3, kLampPositionMm);
    const Eigen::Vector3d to_aim(to[0] - at[0], to[1] - at[1], to[2] - at[2]);
    if (to_aim.norm() < 1e-6)
      section.refuse("aim_mm", en::say("the lamp aims at itself"), en::say("another point"));
    const Eigen::Vector3d aim = to_aim.normalized();
    lamp.aim_x = static_cast<float>(aim.x());
    lamp.aim_y = static_cast<float>(aim.y());
    lamp.aim_z = static_cast<float>(aim.z());
    const int lobe = section.integer("lobe", 1, 8);
    while (1 << lamp.squarings < lobe) ++lamp.squarings;
    if (1 << lamp.squarings != lobe)
      section.refuse("lobe", en::say("unknown lobe"), en::say("1, 2, 4 or 8"));
    return lamp;
  }

  std::vector<Lamp> lamps_;
};

}  // namespace

EffectKind effect_leds() {
  return effect_kind<Leds>(
      "leds", 50, en::say("Lamps light the finger"),
      "lamps: [{at_mm: [0, 3, 0], power: 540000}, {at_mm: [4, 0, -20], power: 3300000, "
      "aim_mm: [71, 0, 93], lobe: 8}]");
}

}  // namespace alltact
