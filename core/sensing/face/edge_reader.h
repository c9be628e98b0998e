// How one edge of the face is read in a sample: where it crosses it, and what lies on both sides.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <limits>
#include <optional>

#include <opencv2/core.hpp>

namespace alltact {

/// Where an edge crosses a sample.
struct EdgeCrossing {
  double offset;       ///< rows below where it was looked for
  double sd;           ///< of the offset, rows
  double contrast;     ///< grey levels
  double outside = 0;  ///< brightness beside the face, grey levels
  double slope = 0;    ///< grey levels a row
  float rise = 0;      ///< of the step, as ExpectedEdge::rise
};

/// What surrounding samples tell of one.
struct ExpectedEdge {
  std::optional<float> beside;  ///< brightness beside the face, grey levels
  /// Of the face's edge over four rows, the two after it less the two before, grey levels.
  float rise = std::numeric_limits<float>::infinity();
};

/// Reads one edge of one picture, sample by sample. Picture and options must outlive it.
class EdgeReader {
 public:
  static constexpr int kWide = 19;  ///< the most rows that can be searched on each side

  /// sign: +1 when brightness rises with v, else -1; face_below: the face lies at larger v.
  EdgeReader(const cv::Mat& grey,
             const FaceEdgeFinder::Options& options,
             double noise_sd,
             float sign,
             bool face_below)
      : grey_(grey), options_(options), noise_sd_(noise_sd), sign_(sign), face_below_(face_below) {}

  /// Looks for the edge up to `reach` rows (at most kWide) on each side of (u, v), along an edge of
  /// that slope. nullopt: there is none, or the sample does not lie in the picture.
  [[nodiscard]] std::optional<EdgeCrossing> at(
      double u, double v, double slope, int reach, const ExpectedEdge& expected = {}) const;
  /// False: it knows nothing of what lies beside the face, and expectations are passed over.
  [[nodiscard]] bool reads_levels() const { return options_.method != EdgeMethod::kInteger; }

 private:
  const cv::Mat& grey_;
  const FaceEdgeFinder::Options& options_;
  double noise_sd_;
  float sign_;
  bool face_below_;
};

}  // namespace alltact
