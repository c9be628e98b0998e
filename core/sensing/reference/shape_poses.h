// Estimates a finger's marker positions from its face's shape alone: for frames in which the
// markers are not found.
#pragma once

#include "core/sensing/markers/layout_search.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/edge_positions.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

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
