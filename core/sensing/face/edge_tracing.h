// One edge of the face along the full image, followed from its clearest sample.
#pragma once

#include "core/sensing/face/face_edges.h"

#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include <opencv2/core.hpp>

namespace alltact {

// Rough position of the face's two long edges: a path through a reduced image for each.

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

// Reads one edge of the face in a sample: its crossing, and the levels on both sides.

/// Where an edge crosses a sample.
struct EdgeCrossing {
  double offset;        ///< rows below the predicted row
  double sd;            ///< of the offset, rows
  double contrast;      ///< grey levels
  double outside = 0;   ///< brightness outside the face, grey levels
  double slope = 0;     ///< grey levels a row
  float steepness = 0;  ///< of the step, as ExpectedEdge::steepness
};

/// Expectation for a sample, from its surrounding samples.
struct ExpectedEdge {
  std::optional<float> outside;  ///< brightness outside the face, grey levels
  /// Rise of the face's edge over four rows, the two after it less the two before, less the mean
  /// rise around it, grey levels.
  float steepness = std::numeric_limits<float>::infinity();
};

/// Reads one edge of one image, sample by sample. Image and options must outlive it.
class EdgeReader {
 public:
  static constexpr int kMaxReach = 19;  ///< maximum rows searched on each side

  /// sign: +1 when brightness rises with v, else -1; face_below: the face is at larger v.
  EdgeReader(const cv::Mat& grey, const FaceEdgeFinder::Options& options, double noise_sd,
             float sign, bool face_below)
      : grey_(grey), options_(options), noise_sd_(noise_sd), sign_(sign), face_below_(face_below) {}

  /// Searches the edge up to `reach` rows (not more than kMaxReach) on each side of (u, v), along
  /// an edge of that slope. nullopt: no edge, or the sample lies outside the image.
  [[nodiscard]] std::optional<EdgeCrossing> at(double u, double v, double slope, int reach,
                                               const ExpectedEdge& expected = {}) const;
  /// False: the method does not measure the level outside the face and ignores expectations.
  [[nodiscard]] bool reads_levels() const { return options_.method != EdgeMethod::kInteger; }

 private:
  const cv::Mat& grey_;
  const FaceEdgeFinder::Options& options_;
  double noise_sd_;
  float sign_;
  bool face_below_;
};

/// Follows the edge from the sample of highest contrast. Further seeds are tried where that edge
/// covers only a part of the image or has gaps, as borders of dots have. The rough path alone may
/// leave the face for the outer border of a side face where that has more contrast. Dots next to
/// the edge are corrected for, and strays beyond its ends are removed. path: of this edge, from
/// `rough`; columns: of the samples (FaceEdges::u).
[[nodiscard]] Edge find_edge(const EdgeReader& reader, const RoughEdges& rough,
                             const RoughEdges::Path& path, const std::vector<double>& columns);

}  // namespace alltact
