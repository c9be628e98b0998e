// Depth that a mapping reads beside contacts, where light scatters sideways through the layer.
//
// A mapping holds brightness for a matter of one pixel. In a layer that scatters, part of a pixel's
// light comes from up to a layer's thickness away: presses of balls, which determine the mapping,
// hide that inside their contacts, and bodies of other shape read wrong by about as much as the
// mapping reads beside a ball. So the rings beside the contacts are measured.
//
// Skin itself is pressed in beside a contact, as an elastic half space (K. L. Johnson, Contact
// Mechanics, eq. 3.42a) that a bonded layer fades within a part of its thickness (ibid. 5.8). What
// is read beyond that, and falls off as light does, may be light: skin that leaves the ball
// unusually early looks the same. A skirt that takes less than about a third of the light is not
// told from skin, nor is one under a bulge: ErrorCause::kBody is there for these.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/presses/press.h"

#include <vector>

namespace alltact {

/// Of all presses together, mm of depth.
struct Halo {
  double near_mm = 0;       ///< read in the ring 0.5 to 1 mm outside the ball's cap, mean
  double far_mm = 0;        ///< in the ring 1.5 to 2 mm outside
  double excess_mm = 0;     ///< near_mm beyond what skin can be pressed in there, mean
  double excess_sd_mm = 0;  ///< standard error of that, by what the presses differ
  int presses = 0;          ///< whose ring is seen
  bool is_seen = false;     ///< significant, and falls off as light does; skin may as well
};
[[nodiscard]] Halo measure_halo(const std::vector<const Press*>& presses,
                                const Face& face,
                                const Calibration& calibration);

}  // namespace alltact
