// Where the view face begins and ends across each column: the first thing read from a picture.
#pragma once

#include "core/result.h"
#include "core/sensing/face/face_ends.h"

#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

/// One of the two edges of the view face, sampled at the columns FaceEdges::u. Positions are in
/// pixels of the oriented picture; sd is the standard deviation expected of the position from the
/// noise and contrast around it. A value without `valid` means nothing and is never invented.
struct Edge {
  std::vector<double> v;
  std::vector<double> sd;
  std::vector<char> valid;
};

struct FaceEdges {
  std::vector<double> u;      ///< centre column of each sample, ascending
  Edge upper;                 ///< at small v
  Edge lower;                 ///< at large v
  FaceEnds ends;              ///< across; no sample beyond them is valid
  double noise_sd = 0;        ///< standard deviation of the picture's noise, grey levels
  bool bright_inside = true;  ///< the face is brighter than what lies beside it
};

enum class EdgeMethod {
  kCrossing = 1,  ///< half-way crossing between the levels on both sides: nearly the best there is
  kInteger,       ///< the steepest whole pixel
};

/// Finds both edges in an 8-bit grey picture without knowing anything of earlier pictures: a small
/// picture says roughly where (dynamic programming over its columns), then only a band around that
/// is read at full resolution, `columns` at a time averaged along the edge's own slope.
class FaceEdgeFinder {
 public:
  struct Options {
    EdgeMethod method = EdgeMethod::kCrossing;
    int columns = 8;  ///< columns averaged into one sample
    std::optional<FaceView> view =
        std::nullopt;  ///< for the ends; none: as if lines stayed straight
  };
  FaceEdgeFinder() = default;
  explicit FaceEdgeFinder(Options options) : options_(std::move(options)) {}

  /// Error: no pair of edges could be followed along at least a fifth of the picture.
  [[nodiscard]] Result<FaceEdges> operator()(const cv::Mat& grey) const;

 private:
  Options options_;
};

}  // namespace alltact
