// Is the finger touched at all, and from where: from the markers alone.
#pragma once

#include "core/finger/finger.h"
#include "core/sensing/markers/markers.h"

#include <optional>
#include <string_view>

#include <Eigen/Core>

namespace alltact {

enum class TouchedFace { kContact = 1, kBack, kUpper, kLower };
[[nodiscard]] std::string_view to_string(TouchedFace face);

struct Touch {
  bool touched = false;
  Eigen::Vector2d offset_px;  ///< o': sum over markers of position - rest position
  /// Below, only when touched: unit offset in the picture plane, its standard deviation, and the
  /// face whose inward normal is nearest: contact +u (towards the tip), back -u, upper +v, lower
  /// -v.
  std::optional<Eigen::Vector3d> direction;
  std::optional<double> sd_deg;  ///< sd_marker * sqrt(number of markers) / |o'|
  std::optional<TouchedFace> face;
};

[[nodiscard]] Touch touch(const Markers& markers,
                          const ContactSettings& settings,
                          bool base_at_low_u);

}  // namespace alltact
