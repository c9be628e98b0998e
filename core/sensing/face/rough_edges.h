// Where the face's two long edges run, roughly: one path through a small picture for each.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

struct RoughEdges {
  /// Rows of the small picture along one edge.
  struct Path {
    std::vector<float> row;  // of the border between two rows
  };

  Path upper, lower;
  std::vector<char> sure;  // small columns where following may begin
  int block = 1;           // picture pixels to one small pixel
  bool bright_inside = true;

  /// The path's place and slope at a column of the picture, px, smoothed over a few small columns.
  static std::pair<double, double> place(const Path& path, int block, double u);
};

/// By dynamic programming over the columns of the picture made small (8-bit grey; noise_sd in grey
/// levels). Side faces that are lit, their outer borders and what presses on the face are told from
/// the face's own edges. nullopt: no pair of edges lies one above the other along the picture.
[[nodiscard]] std::optional<RoughEdges> find_roughly(const cv::Mat& grey, double noise_sd);

}  // namespace alltact
