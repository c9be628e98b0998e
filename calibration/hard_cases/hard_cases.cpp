#include "calibration/hard_cases/hard_cases.h"

#include "calibration/hard_cases/groups.h"

namespace alltact {

std::vector<HardCase> hard_cases() {
  std::vector<HardCase> all;
  for (const auto group : {hard_directions,
                           hard_outlines,
                           hard_faces,
                           hard_curves,
                           hard_lenses,
                           hard_brightness,
                           hard_contacts})
    for (HardCase& one : group()) all.push_back(std::move(one));
  return all;
}

}  // namespace alltact
