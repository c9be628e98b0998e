// Measures one dot at full resolution: position, size, contrast and standard deviation.
#pragma once

#include "core/sensing/face/face_pixels.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

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
[[nodiscard]] std::optional<Dot> measure_dot(const cv::Mat& grey, const SideEdges& edges,
                                             const DotSeed& seed);

/// The dot near a position whose radius and contrast (with sign) are similar to those of `like`.
/// The extents of `like`, where known, set the search window. Searched within `search_px`; nullopt
/// where there is none, or only part of one.
[[nodiscard]] std::optional<Dot> near_dot(const cv::Mat& grey, const SideEdges& edges,
                                          const Eigen::Vector2d& position, double search_px,
                                          const Dot& like);

/// True when one of `dots` is at the position of `dot`.
[[nodiscard]] bool is_among(const std::vector<Dot>& dots, const Dot& dot);

/// True when no neighbour of the pixel is higher; of equal neighbours the first is the peak.
template <class Level>
[[nodiscard]] bool is_peak(const cv::Mat& image, int x, int y) {
  const Level here = image.at<Level>(y, x);
  const int first_x = x > 0 ? x - 1 : 0, last_x = x + 1 < image.cols ? x + 1 : x;
  const int first_y = y > 0 ? y - 1 : 0, last_y = y + 1 < image.rows ? y + 1 : y;
  for (int ny = first_y; ny <= last_y; ++ny) {
    const Level* row = image.ptr<Level>(ny);
    for (int nx = first_x; nx <= last_x; ++nx) {
      const bool is_earlier = ny < y || (ny == y && nx < x);
      if (row[nx] > here || (is_earlier && row[nx] == here)) return false;
    }
  }
  return true;
}

/// The image averaged over complete blocks of an integer `factor` a side, to a width of about
/// kReducedWidthPx, so that a pixel of it is exactly factor x factor of the image.
inline constexpr int kReducedWidthPx = 960;
[[nodiscard]] cv::Mat reduced_for_dots(const cv::Mat& grey, int* factor);

}  // namespace alltact
