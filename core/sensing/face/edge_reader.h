// Reads one edge of the face in a sample: its crossing, and the levels on both sides.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <limits>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Where an edge crosses a sample.
struct EdgeCrossing {
  double offset;       ///< rows below the predicted row
  double sd;           ///< of the offset, rows
  double contrast;     ///< grey levels
  double outside = 0;  ///< brightness outside the face, grey levels
  double slope = 0;    ///< grey levels a row
  float rise = 0;      ///< of the step, as ExpectedEdge::rise
};

/// Expectation for a sample, from its surrounding samples.
struct ExpectedEdge {
  std::optional<float> outside;  ///< brightness outside the face, grey levels
  /// Rise of the face's edge over four rows, the two after it less the two before, grey levels.
  float rise = std::numeric_limits<float>::infinity();
};

/// Reads one edge of one image, sample by sample. Image and options must outlive it.
class EdgeReader {
 public:
  static constexpr int kMaxReach = 19;  ///< maximum rows searched on each side

  /// sign: +1 when brightness rises with v, else -1; face_below: the face is at larger v.
  EdgeReader(const cv::Mat& grey,
             const FaceEdgeFinder::Options& options,
             double noise_sd,
             float sign,
             bool face_below)
      : grey_(grey), options_(options), noise_sd_(noise_sd), sign_(sign), face_below_(face_below) {}

  /// Searches the edge up to `reach` rows (not more than kMaxReach) on each side of (u, v), along
  /// an edge of that slope. nullopt: no edge, or the sample lies outside the image.
  [[nodiscard]] std::optional<EdgeCrossing> at(
      double u, double v, double slope, int reach, const ExpectedEdge& expected = {}) const;
  /// False: the method does not measure the level outside the face and ignores expectations.
  [[nodiscard]] bool reads_levels() const { return options_.method != EdgeMethod::kInteger; }

 private:
  const cv::Mat& grey_;
  const FaceEdgeFinder::Options& options_;
  double noise_sd_;
  float sign_;
  bool face_below_;
};

}  // namespace alltact
