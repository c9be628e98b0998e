// A flat window between the lens and what it looks at: air, a plate, then a clear medium.
//
// The window stands at right angles to the optical axis, the camera's centre in the air before it.
// A lens calibrated in air sees what lies in silicone too large: taken for air, its distance comes
// out by about a quarter too small.
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

/// Where light goes that leaves the camera along `air_direction` (z > 0): a ray in the medium, in
/// the camera's frame and extended backwards to z = 0. Snell's law at both surfaces, exact.
/// nullopt when the direction does not point forwards.
[[nodiscard]] std::optional<Ray> ray_through(const FlatPort& port,
                                             const Eigen::Vector3d& air_direction);

/// The direction in air (z = 1) along which the camera sees a point of the medium: the one root of
/// Snell's law, by Newton's method between bounds, to rounding. nullopt for a point that is not
/// behind the plate, and for one that would be seen more than 89.9 degrees off the axis.
[[nodiscard]] std::optional<Eigen::Vector3d> direction_to(const FlatPort& port,
                                                          const Eigen::Vector3d& point_mm);

/// Distance at which a point on the axis, z_mm away, seems to lie for who takes all for air.
[[nodiscard]] double apparent_distance_mm(const FlatPort& port, double z_mm);

}  // namespace alltact
