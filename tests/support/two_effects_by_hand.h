// The picture of resources/scenes/two_effects.yaml as one writes it by hand: no scene, no effects,
// one loop. What a scene may cost is measured against it.
#pragma once

#include "core/numerics/dispatch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

struct ByHandLamp {
  float x, y, z, power;
};

/// What one row's loop reads: columns of the face, and its two lamps, the second aimed.
struct ByHandRow {
  float direction_y, half_width, scatter, sin, minus_cos, thickness;
  ByHandLamp near_lamp, far_lamp;
  float aim_x, aim_y, aim_z;
  const float *x, *z, *per_mm, *end;
};

ALLTACT_WIDE inline void render_row_by_hand(int first,
                                            int last,
                                            const ByHandRow& r,
                                            std::uint8_t* __restrict bytes) {
  const float* __restrict x = r.x, * __restrict z = r.z;
  const float* __restrict per_mm = r.per_mm, * __restrict end = r.end;
  const float direction_y = r.direction_y, half = r.half_width, nx = r.sin, nz = r.minus_cos;
  const ByHandLamp a = r.near_lamp, b = r.far_lamp;
  const float aim_x = r.aim_x, aim_y = r.aim_y, aim_z = r.aim_z;
  const float t = r.scatter * r.thickness;
  const float reflectance = t / (1.0F + t);
  for (int u = first; u < last; ++u) {
    const float y = direction_y * z[u];
    const float inside = (half - std::abs(y)) * per_mm[u] + 0.5F;
    const float coverage = std::min(std::max(inside, 0.0F), 1.0F) * end[u];
    float dx = a.x - x[u], dy = a.y - y, dz = a.z - z[u];
    float r2 = dx * dx + dy * dy + dz * dz;
    float facing = nx * dx + nz * dz;
    float light = a.power * std::max(facing, 0.0F) / (r2 * std::sqrt(r2));
    dx = b.x - x[u], dy = b.y - y, dz = b.z - z[u];
    r2 = dx * dx + dy * dy + dz * dz;
    const float distance = std::sqrt(r2);
    facing = nx * dx + nz * dz;
    float lobe = std::max(-(aim_x * dx + aim_y * dy + aim_z * dz) / distance, 0.0F);
    lobe *= lobe;
    lobe *= lobe;
    lobe *= lobe;
    light += b.power * lobe * std::max(facing, 0.0F) / (r2 * distance);
    const float value = coverage * (reflectance * light);
    const float level = std::min(std::max(value, 0.0F), 255.0F);
    bytes[u] = static_cast<std::uint8_t>(static_cast<int>(level + 0.5F));
  }
}

/// A frame: where each column meets the face, then row by row.
inline cv::Mat two_effects_by_hand() {
  constexpr int kWidth = 1920, kHeight = 1080;
  constexpr double kF = 1047.8, kCx = 959.5, kCy = 539.5, kX = -25, kZ = 28, kLength = 116;
  const double incline = 34.0 * std::numbers::pi / 180;
  const double cos = std::cos(incline), sin = std::sin(incline);
  std::vector<float> x(kWidth), z(kWidth), per_mm(kWidth), end(kWidth);
  for (std::size_t u = 0; u < kWidth; ++u) {
    const double direction = static_cast<float>((static_cast<double>(u) - kCx) / kF);
    const double crossing = cos - direction * sin;
    const double s = -(kX - direction * kZ) / crossing;
    const double z_mm = kZ + s * sin;
    x[u] = static_cast<float>(kX + s * cos);
    z[u] = static_cast<float>(z_mm);
    per_mm[u] = static_cast<float>(1 / (z_mm / kF));
    end[u] = static_cast<float>(
        std::clamp(std::min(s, kLength - s) / (z_mm / kF / crossing) + 0.5, 0.0, 1.0));
  }
  ByHandRow row{};
  row.half_width = 12;
  row.scatter = 0.6F;
  row.sin = static_cast<float>(sin), row.minus_cos = -static_cast<float>(cos);
  row.thickness = static_cast<float>(1.5 / cos) * static_cast<float>(cos);
  row.near_lamp = {0, 0, 0, 540000};
  row.far_lamp = {4, 0, -20, 3300000};
  const Eigen::Vector3d aim = Eigen::Vector3d(67, 0, 113).normalized();
  row.aim_x = static_cast<float>(aim.x()), row.aim_y = static_cast<float>(aim.y());
  row.aim_z = static_cast<float>(aim.z());
  row.x = x.data(), row.z = z.data(), row.per_mm = per_mm.data(), row.end = end.data();
  const auto shines = [](float part) { return part > 0; };
  const auto face_first = std::find_if(end.begin(), end.end(), shines) - end.begin();
  const auto face_last = end.rend() - std::find_if(end.rbegin(), end.rend(), shines);
  cv::Mat picture(kHeight, kWidth, CV_8UC1);
  for (int v = 0; v < kHeight; ++v) {
    row.direction_y = static_cast<float>((v - kCy) / kF);
    // The face gets narrower from column to column, and farther away.
    const float farthest = 12.1F / std::max(std::abs(row.direction_y), 1e-6F);
    const auto z_end = std::lower_bound(z.begin(), z.end(), farthest);
    const auto first = static_cast<int>(face_first);
    const auto last = std::max(first, static_cast<int>(std::min(z_end - z.begin(), face_last)));
    std::uint8_t* bytes = picture.ptr(v);
    std::fill(bytes, bytes + first, std::uint8_t{0});
    std::fill(bytes + last, bytes + kWidth, std::uint8_t{0});
    render_row_by_hand(first, last, row, bytes);
  }
  return picture;
}

}  // namespace alltact
