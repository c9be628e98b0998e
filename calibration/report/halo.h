// Depth that a mapping reads next to contacts, where light scatters sideways through the layer.
//
// A mapping treats brightness as local to one pixel. In a layer that scatters, part of a pixel's
// light comes from up to a layer's thickness away. Presses of balls, which determine the mapping,
// hide that inside their contacts. Bodies of other shape are misread by about as much as the
// mapping reads next to a ball, so the rings around the contacts are measured.
//
// Skin itself is pressed in next to a contact, as an elastic half space (K. L. Johnson, Contact
// Mechanics, eq. 3.42a) that a bonded layer fades within a part of its thickness (ibid. 5.8). Depth
// beyond that, with the decay of light, may be light; skin that leaves the ball unusually early
// looks the same. A skirt of less than about a third of the light cannot be separated from skin,
// nor one under a bulge. ErrorCause::kBody covers these.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"

#include <vector>

namespace alltact {

/// Means over all presses, mm of depth.
struct Halo {
  double near_mm = 0;       ///< read in the ring 0.5 to 1 mm outside the ball's cap, mean
  double far_mm = 0;        ///< in the ring 1.5 to 2 mm outside
  double excess_mm = 0;     ///< near_mm beyond the possible indentation of skin there, mean
  double excess_sd_mm = 0;  ///< standard error of that, by the scatter of the presses
  int presses = 0;          ///< with a visible ring
  bool is_seen = false;     ///< significant, and decays as light does; skin may as well
};
[[nodiscard]] Halo measure_halo(const std::vector<const Press*>& presses,
                                const Face& face,
                                const Calibration& calibration);

}  // namespace alltact
