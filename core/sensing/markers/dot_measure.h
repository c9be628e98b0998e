// One dot, measured at full resolution: where, how large, how bright, how surely.
#pragma once

#include "core/sensing/face/side_edges.h"
#include "core/sensing/markers/markers.h"

#include <optional>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// Pixels this near the view face's edges take part in no dot unless the light that the edge
/// spreads there is known (see dot_window.h).
inline constexpr double kFaceMarginPx = 2.0;

/// Where to look for a dot: its rough centre and half extents at half its height.
struct DotSeed {
  double u = 0, v = 0;
  double half_u = 2, half_v = 2;
  bool upper = false;
  double sign = 1;            ///< +1 bright, -1 dark
  double least_contrast = 3;  ///< grey levels
};

/// Grows the region above half height around the seed, checks that it is a lone compact spot, and
/// takes the centroid of what stands above a plane through its surroundings. The window of the
/// centroid is kept symmetric about the dot where the view face cuts into it, so that a near edge
/// does not pull. nullopt: nothing there, touching the picture's border or the view face, or no
/// compact spot.
[[nodiscard]] std::optional<Dot> measure_dot(const cv::Mat& grey,
                                             const SideEdges& edges,
                                             const DotSeed& seed);

/// The dot near a place, when its radius and contrast (with sign) are about those of `like`, whose
/// extents, where it has any, say where to look. Searched within `search_px`; nullopt where there
/// is none, or only part of one.
[[nodiscard]] std::optional<Dot> near_dot(const cv::Mat& grey,
                                          const SideEdges& edges,
                                          const Eigen::Vector2d& place,
                                          double search_px,
                                          const Dot& like);

}  // namespace alltact
