// Measures one dot at full resolution: position, size, contrast and standard deviation.
#pragma once

#include "core/sensing/face/face_pixels.h"
#include "core/sensing/markers/markers.h"

#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Pixels this near to the view face's edges are excluded, unless the light that the edge spreads
/// there is known.
inline constexpr double kFaceMarginPx = 2.0;

/// Initial guess of a dot: its rough centre and half extents at half its height.
struct DotSeed {
  double u = 0, v = 0;
  double half_u = 2, half_v = 2;
  bool upper = false;
  double sign = 1;          ///< +1 bright, -1 dark
  double min_contrast = 3;  ///< grey levels
};

/// Grows the region above half height around the seed and checks that it is a lone compact spot.
/// Then computes the centroid of the heights above a plane through its surroundings. Where the view
/// face cuts into the centroid's window, it is made symmetric about the dot, so that a near edge
/// causes no bias. nullopt: no compact spot, or one that reaches the border of the image or the
/// view face.
[[nodiscard]] std::optional<Dot> measure_dot(const cv::Mat& grey,
                                             const SideEdges& edges,
                                             const DotSeed& seed);

/// The dot near a position whose radius and contrast (with sign) are similar to those of `like`.
/// The extents of `like`, where known, set the search window. Searched within `search_px`; nullopt
/// where there is none, or only part of one.
[[nodiscard]] std::optional<Dot> near_dot(const cv::Mat& grey,
                                          const SideEdges& edges,
                                          const Eigen::Vector2d& position,
                                          double search_px,
                                          const Dot& like);

}  // namespace alltact
