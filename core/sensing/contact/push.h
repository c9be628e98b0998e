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
  /// Below, only when pushed: unit offset in the picture plane, its standard deviation, and the
  /// face whose inward normal is nearest: contact +u (towards the tip), back -u, upper +v, lower
  /// -v.
  std::optional<Eigen::Vector3d> direction;
  std::optional<double> sd_deg;  ///< sd_marker * sqrt(number of markers) / |o'|
  std::optional<PushedFace> face;
};

/// Not pushed, offset 0: the markers are not those of the settings, or one lies nowhere.
[[nodiscard]] Push push_of(const Markers& markers,
                           const ContactSettings& settings,
                           bool base_at_low_u);

}  // namespace alltact
