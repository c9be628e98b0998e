// Where a finger's markers must be, by its face's shape alone: for frames in which they are not
// found.
#pragma once

#include "core/sensing/markers/layout_search.h"
#include "core/sensing/markers/markers.h"
#include "core/sensing/reference/pose_places.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Learnt from recorded frames, each the shape of its face and where its markers lie.
class ShapePoses {
 public:
  /// faces: of the frames; layouts: one row a frame, 2n markers as (u0, v0, u1, v1, ...), px,
  /// finite. nullopt where the faces have too little in common, or fewer than 8 frames show it all.
  static std::optional<ShapePoses> learn(const std::vector<EdgeCurves>& faces,
                                         const Eigen::MatrixXd& layouts);

  struct Told {
    /// 2n estimates, none seen; sd_px is how far such estimates lie off in the recording itself.
    Markers markers;
    double distance_px = 0;  ///< mean distance of the face's places to the nearest frame's
    bool known_pose = true;  ///< false: further away than the recording's own frames are apart
  };
  /// nullopt: too little of the face is seen.
  [[nodiscard]] std::optional<Told> operator()(const FaceShape& shape) const;

 private:
  ShapePoses(PosePlaces places, MarkerModel model, LayoutSearch search)
      : places_(places), model_(std::move(model)), search_(std::move(search)) {}
  /// The markers' layout by the frames nearest to a face's, `without` (by row) left out.
  [[nodiscard]] Eigen::VectorXd layout_at(const Eigen::VectorXd& place,
                                          const std::vector<char>& without) const;
  void learn_sd();

  PosePlaces places_;
  MarkerModel model_;          // of the places
  LayoutSearch search_;        // of the places
  Eigen::MatrixXd modes_;      // of the places, px, a row a frame
  Eigen::MatrixXd layouts_;    // of the markers, a row a frame
  std::vector<double> sd_px_;  // by marker
  double known_px_ = 0;
};

}  // namespace alltact
