// The picture of resources/scenes/two_effects.yaml as one writes it by hand: no scene, no effects,
// one loop over what the face's geometry gives. What a scene may cost is measured against it.
#pragma once

#include "core/camera/camera.h"
#include "core/finger/finger.h"
#include "core/numerics/dispatch.h"
#include "core/simulation/frame_geometry.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <opencv2/core.hpp>

namespace alltact {

// The layer, a bare lamp, one aimed with a lobe of cos^8, and grey levels.
ALLTACT_WIDE inline void two_effects_row(const FaceRow& face, const Surface& surface,
                                         std::uint8_t* __restrict bytes) {
  constexpr float kScatter = 0.6F, kNearPower = 540000, kFarPower = 3300000;
  constexpr float kFarX = 4, kFarZ = -20;
  const auto aim_length = static_cast<float>(std::hypot(67.0, 113.0));
  const float aim_x = 67 / aim_length, aim_z = 113 / aim_length;
  const float* __restrict x = face.x_mm, * __restrict y = face.y_mm, * __restrict z = face.z_mm;
  const float* __restrict nx = surface.normal_x, * __restrict ny = surface.normal_y;
  const float* __restrict nz = surface.normal_z, * __restrict coverage = face.coverage;
  const float* __restrict luf = face.luf_mm, * __restrict cos = face.cos_incline;
  for (int u = face.first; u < face.last; ++u) {
    const float t = kScatter * (luf[u] * cos[u]);
    float dx = -x[u], dy = -y[u], dz = -z[u];
    float r2 = dx * dx + dy * dy + dz * dz;
    float facing = nx[u] * dx + ny[u] * dy + nz[u] * dz;
    float light = kNearPower * std::max(facing, 0.0F) / (r2 * std::sqrt(r2));
    dx = kFarX - x[u], dz = kFarZ - z[u];
    r2 = dx * dx + dy * dy + dz * dz;
    const float r = std::sqrt(r2);
    facing = nx[u] * dx + ny[u] * dy + nz[u] * dz;
    float lobe = std::max(-(aim_x * dx + 0.0F * dy + aim_z * dz) / r, 0.0F);
    lobe *= lobe;
    lobe *= lobe;
    lobe *= lobe;
    light += kFarPower * lobe * std::max(facing, 0.0F) / (r2 * r);
    const float grey = coverage[u] * (t / (1.0F + t) * light);
    const float level = std::min(std::max(grey, 0.0F), 255.0F);
    bytes[u] = static_cast<std::uint8_t>(static_cast<int>(level + 0.5F));
  }
}

/// A frame: where the face is, then row by row. `rays` are made once, as a Plan does.
inline cv::Mat two_effects_by_hand(const PixelRays& rays, const Face& face) {
  FaceCurve curve({-25, 0, 28}, 34 * std::numbers::pi / 180, 116);
  curve.integrate();
  const FrameGeometry geometry(rays, face, std::move(curve));
  cv::Mat image(rays.camera().size(), CV_8UC1);
  RowScratch scratch(image.cols);
  RowView row(image.cols, scratch);
  for (int v = 0; v < image.rows; ++v) {
    scratch.rewind();
    row.v = v;
    geometry.fill(row);
    std::uint8_t* bytes = image.ptr(v);
    std::fill(bytes, bytes + row.face.first, std::uint8_t{0});
    two_effects_row(row.face, row.surfaces.front(), bytes);
    std::fill(bytes + row.face.last, bytes + image.cols, std::uint8_t{0});
  }
  return image;
}

}  // namespace alltact
