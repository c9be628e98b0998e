// Upper and lower edge of the view face in each column: the first step of an image's analysis.
#pragma once

#include "core/result.h"
#include "core/sensing/face/face_ends.h"

#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// One of the two edges of the view face, sampled at the columns FaceEdges::u. Positions in pixels
/// of the oriented image; sd: the standard deviation expected from the noise and contrast around
/// the position. A value that is not `valid` has no meaning.
struct Edge {
  std::vector<double> v;
  std::vector<double> sd;
  std::vector<char> valid;
};

struct FaceEdges {
  std::vector<double> u;      ///< centre column of each sample, ascending
  Edge upper;                 ///< at small v
  Edge lower;                 ///< at large v
  FaceEnds ends;              ///< across the finger; no sample beyond them is valid
  double noise_sd = 0;        ///< standard deviation of the image's noise, grey levels
  bool bright_inside = true;  ///< the face is brighter than its surroundings
};

enum class EdgeMethod {
  kCrossing = 1,  ///< crossing of the mean of both sides' levels: nearly optimal
  kInteger,       ///< the steepest integer pixel
};

/// Finds both edges in an 8-bit grey image, independently of earlier images. A reduced image gives
/// their rough path by dynamic programming over its columns. Then only a band around it is read at
/// full resolution, `columns` at a time averaged along the edge's own slope.
class FaceEdgeFinder {
 public:
  struct Options {
    EdgeMethod method = EdgeMethod::kCrossing;
    int columns = 8;  ///< columns averaged into one sample
    std::optional<FaceView> view =
        std::nullopt;  ///< for the ends; none: straight lines are assumed to stay straight
  };
  FaceEdgeFinder() = default;
  explicit FaceEdgeFinder(Options options) : options_(std::move(options)) {}

  /// Error: no pair of edges could be followed along a fifth of the image.
  [[nodiscard]] Result<FaceEdges> operator()(const cv::Mat& grey) const;

 private:
  Options options_;
};

}  // namespace alltact
