// Detects whether the finger is pushed, and from which side, from the markers alone. Other notions
// of contact: see contact_regions.h.
#pragma once

#include "core/finger/finger.h"
#include "core/finger/pushed_face.h"
#include "core/sensing/markers/markers.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

struct Push {
  bool pushed = false;
  Eigen::Vector2d offset_px;  ///< o': sum over markers of position - rest position
  Eigen::Matrix2d offset_covariance_px2 = Eigen::Matrix2d::Zero();
  /// Set only when pushed: unit offset in the image plane, its standard deviation, and the face
  /// whose inward normal is nearest. Contact is +u (towards the tip), back -u, upper +v, lower -v.
  std::optional<Eigen::Vector3d> direction;
  std::optional<double> sd_deg;  ///< of offset_covariance_px2 across the direction, over |o'|
  std::optional<PushedFace> face;
};

/// Covariance (4n x 4n) of the markers' displacements from rest. `now_px2` is that of their current
/// positions (MarkerModel::covariance_px2); without it each has its own sd_px. The covariance of
/// the rest layout, one frame of the recording, is added. Each marker has the same sd there as now;
/// a marker that is not seen now has the mean of the seen ones.
[[nodiscard]] Eigen::MatrixXd displacement_covariance_px2(
    const Markers& markers, const std::optional<Eigen::MatrixXd>& now_px2 = std::nullopt);

/// `displacement_cov_px2`: the above; empty: without now_px2. Returns no push and offset 0 where
/// the markers are not those of the settings, or one has no position.
[[nodiscard]] Push push_of(const Markers& markers,
                           const ContactSettings& settings,
                           bool base_at_low_u,
                           const Eigen::MatrixXd& displacement_cov_px2 = {});

}  // namespace alltact
