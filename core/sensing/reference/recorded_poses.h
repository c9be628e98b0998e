// Exact search for the recorded layout nearest to the markers.
//
// Layouts are in about sqrt(n) groups. With a group's centre c and, of each marker, the largest
// distance r of its layouts from c, no layout of the group is nearer to q than
//   sum over the markers that count of max(0, |q - c| - r)
// by the triangle inequality, for any choice of markers. Groups are searched in the order of these
// bounds until the next bound exceeds the best distance.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/face/face_shape.h"
#include "core/sensing/markers/marker_model.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The recorded frame nearest to the markers of another.
struct NearestFrame {
  int row = 0;             ///< index into the recording
  double distance_px = 0;  ///< mean over the markers that count
};

class LayoutSearch {
 public:
  /// layouts: one row a frame, (u0, v0, u1, ...), px, at least one row, finite.
  explicit LayoutSearch(const Eigen::MatrixXd& layouts);

  /// The row with the smallest mean distance over the seen markers (all, when none is seen). The
  /// lowest row wins a tie. `without` (by row) marks excluded rows; empty: none. Without any row
  /// left the distance is infinite.
  [[nodiscard]] NearestFrame nearest(const Markers& markers,
                                     const std::vector<char>& without = {}) const;

  /// Mean distance, over the same markers, to the sum of weights[i] times row rows[i].
  [[nodiscard]] double distance_px(const Markers& markers, const std::vector<int>& rows,
                                   const Eigen::VectorXd& weights) const;

  /// Median over the rows (about 200 of them at most) of the distance to the nearest other row.
  [[nodiscard]] double median_step_px() const;

  [[nodiscard]] std::size_t memory_bytes() const;

 private:
  /// A group of neighbouring layouts.
  struct Group {
    std::size_t begin, end;       // indices into rows_
    std::vector<float> centre;    // u0, v0, u1, ...
    std::vector<float> reach_px;  // largest distance from the centre, by marker
  };
  struct Bound {
    float lower_bound;  // sum over the markers that count
    std::size_t group;
  };
  /// View of one layout within the storage of its group.
  struct Stored {
    const float* first;
    std::size_t step;
    [[nodiscard]] double u(std::size_t marker) const {
      return static_cast<double>(first[2 * marker * step]);
    }
    [[nodiscard]] double v(std::size_t marker) const {
      return static_cast<double>(first[(2 * marker + 1) * step]);
    }
  };
  [[nodiscard]] Stored stored(std::size_t row) const;
  void group_layouts(const Eigen::MatrixXd& layouts, std::size_t count);
  [[nodiscard]] std::vector<Bound> bounds(const Markers& markers) const;

  std::size_t frames_, markers_;
  std::vector<int> rows_;  // by group, ascending within each
  std::vector<float>
      coordinates_;  // by group: u0 of all its layouts, v0 of all, u1 ...: contiguous for loops
  std::vector<std::size_t> index_of_row_;  // index in rows_, by row
  std::vector<Group> groups_;
};

/// Largest distance of the nearest layout at which a pose counts as recorded, px: three times the
/// median step, at least 1.5 px.
[[nodiscard]] double known_distance_px(const LayoutSearch& search);

// Weights of the recorded neighbours in the reference of a pose.

/// Weights of a local linear regression at `query` over the rows of `points` (coordinates in px).
/// They sum to 1 and minimise
///   |query - sum w_i p_i|^2 / ridge_px^2 + sum w_i^2 / k_i,
/// with k_i a kernel that falls with the distance. Inside the neighbours' hull they reproduce the
/// query and everything that is linear in the pose. Where the neighbours lie on a line or the query
/// outside, the ridge limits the weights. It is raised until sum |w_i| <= `max_magnitude`; in the
/// limit the weights are those of a kernel mean.
[[nodiscard]] Eigen::VectorXd local_linear_weights(const Eigen::MatrixXd& points,
                                                   const Eigen::VectorXd& query, double ridge_px,
                                                   double max_magnitude);

inline constexpr int kPoseNeighbours = 8;  ///< default: more gain little and cost their share

/// Recorded frames that approximate a pose together.
struct PoseNeighbours {
  std::vector<int> rows;
  Eigen::VectorXd weights;  ///< sum to 1
  /// Distance of the pose from its neighbours, px^2: sum |w_i| |p_i - pose|^2, with which the error
  /// of a local linear regression grows. To it comes the residual of the pose times the neighbours'
  /// distance.
  double reach_px2 = 0;
};

/// Selects `count` rows of `modes` (a row per frame, px) near the `pose` and on all sides of it,
/// the nearest first; their weights are local_linear_weights(). The nearest frames alone are often
/// from one move, in a line, and a regression over a line does not constrain other directions. Over
/// simulated fingers the markers of the combined frames lie half as far from those of the pose as
/// with the nearest alone. marker_count: of the layouts of the modes. `without` (by row) marks
/// frames to exclude, empty: none.
[[nodiscard]] PoseNeighbours pose_neighbours(const Eigen::MatrixXd& modes,
                                             const Eigen::VectorXd& pose, int marker_count,
                                             const std::vector<char>& without,
                                             int count = kPoseNeighbours);

// The pose of a finger from its face's shape alone: positions on both edges replace markers.

/// Both edges of the face at every eighth valid column: small enough to store for every frame of a
/// recording.
struct EdgeCurves {
  std::vector<float> u, upper, lower;  ///< px, u ascending
  std::vector<float> along_mm;         ///< arc length of the face from its base
  bool base_at_low_u = true;
};
[[nodiscard]] EdgeCurves edge_curves(const FaceShape& shape);

/// Arc length of the face in column u, extrapolated linearly beyond the curves' ends. 0 for empty
/// curves.
[[nodiscard]] double along_mm_at(const EdgeCurves& curves, double u);

/// Middle between both edges in column u, px, extrapolated linearly beyond the ends. 0 for empty
/// curves.
[[nodiscard]] double middle_at(const EdgeCurves& curves, double u);

/// Mean distance in v, px, of two faces' edges over their common columns; infinite where these are
/// less than half of either.
[[nodiscard]] double edge_distance_px(const EdgeCurves& a, const EdgeCurves& b);

/// Positions that nearly all of the faces show, from the base to the tip. nullopt: the faces have
/// no length in common.
[[nodiscard]] std::optional<EdgePositions> choose_edge_positions(
    const std::vector<EdgeCurves>& faces);

/// The positions of one face, numbered like markers (upper edge from base to tip, then the lower
/// one). Positions outside of its valid columns are not seen.
[[nodiscard]] Markers markers_at(const EdgePositions& positions, const EdgeCurves& curves);

// Estimates a finger's marker positions from its face's shape alone: for frames in which the
// markers are not found.

/// Learnt from recorded frames: the shape of each face and its marker positions.
class ShapePoses {
 public:
  /// faces: of the frames; layouts: one row per frame, 2n markers as (u0, v0, u1, v1, ...), px,
  /// finite. nullopt where the faces have too little in common, or fewer than 8 frames show all of
  /// it.
  static std::optional<ShapePoses> learn(const std::vector<EdgeCurves>& faces,
                                         const Eigen::MatrixXd& layouts);

  struct Estimate {
    /// 2n estimates, none seen; sd_px is the error of such estimates in the recording itself.
    Markers markers;
    double distance_px = 0;  ///< mean distance of the face's edge positions to the nearest frame's
    bool known_pose = true;  ///< false: further away than the recording's own frames are apart
  };
  /// nullopt: too little of the face is seen.
  [[nodiscard]] std::optional<Estimate> operator()(const FaceShape& shape) const;

 private:
  ShapePoses(EdgePositions positions, MarkerModel model, LayoutSearch search)
      : positions_(positions), model_(std::move(model)), search_(std::move(search)) {}
  /// The markers' layout from the frames nearest to a face, `without` (by row) excluded.
  [[nodiscard]] Eigen::VectorXd layout_at(const Eigen::VectorXd& pose,
                                          const std::vector<char>& without) const;
  void learn_sd();

  EdgePositions positions_;
  MarkerModel model_;          // of the edge positions
  LayoutSearch search_;        // of the edge positions
  Eigen::MatrixXd modes_;      // of the edge positions, px, a row per frame
  Eigen::MatrixXd layouts_;    // of the markers, a row per frame
  std::vector<double> sd_px_;  // by marker
  double known_px_ = 0;
};

}  // namespace alltact
