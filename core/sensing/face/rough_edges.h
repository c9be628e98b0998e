// Rough position of the face's two long edges: a path through a reduced image for each.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct RoughEdges {
  /// Rows of the reduced image along one edge.
  struct Path {
    std::vector<float> row;  // row of the border between two pixels, by column
  };

  Path upper, lower;
  std::vector<char> can_seed;  // by small column: following may begin there
  int block = 1;               // image pixels a side of one small pixel
  bool bright_inside = true;

  /// Row and slope of the path at column u of the image, px, smoothed over a few small columns.
  static std::pair<double, double> position_at(const Path& path, int block, double u);
};

/// Finds both edges by dynamic programming over the columns of the reduced image (8-bit grey;
/// noise_sd in grey levels). Distinguishes lit side faces, their outer borders and objects on the
/// face from the face's own edges. nullopt: no pair of edges lies one above the other along the
/// image.
[[nodiscard]] std::optional<RoughEdges> find_rough_edges(const cv::Mat& grey, double noise_sd);

}  // namespace alltact
