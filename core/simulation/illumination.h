// What is done to the lamps and to their light in one frame.
#pragma once

#include "core/simulation/indirect_light.h"

#include <map>
#include <memory>

namespace alltact {

/// As it stands here: every lamp gives its whole power, nothing else shines, nothing absorbs.
struct Illumination {
  double lamp_share = 1;               ///< of their power that all lamps give
  std::map<int, double> single_share;  ///< and of which one lamp gives this share, by number
  double room_level = 0;     ///< light from everywhere, grey levels of a perfectly white surface
  double absorb_per_mm = 0;  ///< of the clear body, along the way from a lamp and to the camera
  std::shared_ptr<const IndirectLight> indirect;  ///< null: nothing but lamps and room shines

  [[nodiscard]] double share_of(int lamp) const {
    const auto single = single_share.find(lamp);
    return single == single_share.end() ? lamp_share : lamp_share * single->second;
  }
};

}  // namespace alltact
