// Is the finger pushed at all, and from where: from the markers alone. Other kinds of touch: see
// contact_regions.h.
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
  /// Below, only when pushed: unit offset in the picture plane, its standard deviation, and the
  /// face whose inward normal is nearest: contact +u (towards the tip), back -u, upper +v, lower
  /// -v.
  std::optional<Eigen::Vector3d> direction;
  std::optional<double> sd_deg;  ///< of offset_covariance_px2 across the direction, over |o'|
  std::optional<PushedFace> face;
};

/// Covariance (4n x 4n) of the markers' ways from rest. `now_px2` is that of where they are now
/// (MarkerModel::covariance_px2), without it each errs by its own sd_px. To this comes the rest
/// layout, which is that of one frame of the recording: each marker as sure there as it is now, one
/// that is not seen now as those that are on average.
[[nodiscard]] Eigen::MatrixXd ways_covariance_px2(
    const Markers& markers, const std::optional<Eigen::MatrixXd>& now_px2 = std::nullopt);

/// `ways_px2`: the above; empty: without now_px2.
/// Not pushed, offset 0: the markers are not those of the settings, or one lies nowhere.
[[nodiscard]] Push push_of(const Markers& markers,
                           const ContactSettings& settings,
                           bool base_at_low_u,
                           const Eigen::MatrixXd& ways_px2 = {});

}  // namespace alltact
