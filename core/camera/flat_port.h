// A flat window between lens and finger: air, a plate, then a clear medium.
//
// The window is perpendicular to the optical axis, with the camera's centre in the air before it. A
// lens calibrated in air shows objects in silicone too large: without this model their distance is
// about a quarter too small.
#pragma once

#include "core/camera/ray.h"
#include "core/result.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

struct FlatPort {
  double gap_mm = 0;           ///< air between the camera's centre and the plate, 0 to 1000
  double plate_mm = 0;         ///< thickness of the plate, 0 to 1000
  double plate_index = 1.49;   ///< of refraction, 1 to 3; acrylic
  double medium_index = 1.41;  ///< of refraction, 1 to 3; silicone

  bool operator==(const FlatPort&) const = default;
};

/// Error: a number outside its range; `where` names it ("gap_mm").
[[nodiscard]] Status check_port(const FlatPort& port);

/// The ray in the medium of light that leaves the camera along `air_direction` (z > 0), in the
/// camera frame and extended backwards to z = 0. Snell's law at both surfaces, exact. nullopt when
/// the direction does not point forwards.
[[nodiscard]] std::optional<Ray> ray_through(const FlatPort& port,
                                             const Eigen::Vector3d& air_direction);

/// The direction in air (z = 1) along which the camera sees a point of the medium: the one root of
/// Snell's law, by Newton's method between bounds, to rounding. nullopt for a point not behind the
/// plate, or seen more than 89.9 degrees off the axis.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_to(const FlatPort& port,
                                                          const Eigen::Vector3d& point_mm);

/// Apparent distance in air of a point on the axis at z_mm.
[[nodiscard]] double apparent_distance_mm(const FlatPort& port, double z_mm);

}  // namespace alltact
