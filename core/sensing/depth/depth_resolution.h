// How fine a form of the skin the depth of an image resolves.
//
// A small indentation that varies along the face as a wave exp(i k r) is measured with the gain
//   H(k) = lens(k) smoothing(k) removal(k)
// lens: the blur of a sharp image (kOpticsPx2). smoothing: the kernel before depth is computed.
// removal: what is left of spread light and of its removal (light_spread.h), 1 where light is
// local. The inverse Fourier transform of H is the depth that a point of the skin gives; all
// figures below follow from it.
//
// The figures concern the skin. A body whose edges the skin does not follow is blunter before it is
// measured. They hold for small depths, without noise, and for a lens in focus.
#pragma once

#include "core/finger/mapping.h"
#include "core/sensing/depth/smoothing.h"
#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// All in mm on the face, > 0, the larger of along and across; at most kMaxMm.
struct DepthResolution {
  static constexpr double kMaxMm = 5.0;
  /// Two equal points are seen apart from this distance on: between them the depth falls to four
  /// fifths (Rayleigh: 0.81 behind a slit), and a pixel lies between their own.
  double two_points_mm = kMaxMm;
  double wall_mm = kMaxMm;  ///< the narrowest long wall whose depth is right within a tenth
  double pin_mm = kMaxMm;   ///< the thinnest round pin likewise, its diameter
  double step_mm = kMaxMm;  ///< distance from a step beyond which depth is right within its tenth
  /// Contrast of kWaves waves, by their number: the modulation transfer function.
  std::vector<double> contrasts;
  static constexpr int kWaves = 31;
  /// 0, 0.1, 0.2, .. waves per mm.
  [[nodiscard]] static constexpr double wave_per_mm(int number) { return number / 10.0; }
};

/// At a position on the face (FaceShape::position_mm) of an image with this shape. `mapping`: its
/// spread counts. nullopt: the position is off the visible face.
[[nodiscard]] std::optional<DepthResolution> depth_resolution_at(const FaceShape& shape,
                                                                 const Eigen::Vector2d& position_mm,
                                                                 const MappingParameters& mapping,
                                                                 const Smoothing& smoothing);

}  // namespace alltact
