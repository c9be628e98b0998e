// The state of the lamps and of their light in one frame.
#pragma once

#include "core/simulation/indirect_light.h"

#include <map>
#include <memory>

namespace alltact {

/// Default: every lamp has its full power, nothing else shines, nothing absorbs.
struct Illumination {
  double lamp_share = 1;               ///< fraction of their power, for all lamps
  std::map<int, double> single_share;  ///< additional fraction for one lamp, by number
  double room_level = 0;     ///< light from all directions, grey levels of a white surface
  double absorb_per_mm = 0;  ///< of the clear body, along the path from a lamp and to the camera
  std::shared_ptr<const IndirectLight> indirect;  ///< null: only lamps and room shine

  [[nodiscard]] double share_of(int lamp) const {
    const auto single = single_share.find(lamp);
    return single == single_share.end() ? lamp_share : lamp_share * single->second;
  }
};

}  // namespace alltact
