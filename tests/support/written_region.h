// A contact as results.jsonl holds it, every field told.
#pragma once

#include "core/sensing/contact/contact_regions.h"

namespace alltact::test {

inline ContactRegion written_region() {
  ContactRegion region;
  region.position_mm = {3.1, -0.2, 48.0};
  region.position_px = {100, 100};
  region.deepest_point_mm = region.position_mm;
  region.deepest_mm = 0.8;
  region.position_covariance_mm2 = Eigen::Vector3d(0.01, 0.02, 0.04).asDiagonal();
  region.angle_deg = 12.5, region.angle_sd_deg = 0.25;
  region.axis = Eigen::Vector3d(0.6, 0, 0.8);
  region.normal = Eigen::Vector3d(-0.8, 0, 0.6);
  region.polygon_mm = {{1, 2}, {3, 4}, {1, 5}};
  return region;
}

}  // namespace alltact::test
