#include "calibration/report/press_resolution.h"

#include <algorithm>

namespace alltact {

void set_resolutions(const std::vector<const Press*>& presses, const MappingParameters& mapping,
                     const Smoothing& smoothing, std::vector<PressResiduals>* contacts) {
  for (PressResiduals& contact : *contacts) {
    const auto press = std::find_if(presses.begin(), presses.end(),
                                    [&](const Press* one) { return one->name == contact.press; });
    if (press != presses.end())
      contact.resolution = depth_resolution_at(
          (*press)->shape, {contact.along_mm, contact.across_mm}, mapping, smoothing);
  }
}

std::optional<DepthResolution> worst_resolution(const std::vector<PressResiduals>& contacts) {
  std::optional<DepthResolution> worst;
  for (const PressResiduals& contact : contacts) {
    if (!contact.resolution) continue;
    const DepthResolution& here = *contact.resolution;
    if (!worst) {
      worst = here;
      continue;
    }
    for (const auto figure : {&DepthResolution::two_points_mm, &DepthResolution::wall_mm,
                              &DepthResolution::pin_mm, &DepthResolution::step_mm})
      *worst.*figure = std::max(*worst.*figure, here.*figure);
    for (std::size_t i = 0; i < worst->contrasts.size(); ++i)
      worst->contrasts[i] = std::min(worst->contrasts[i], here.contrasts[i]);
  }
  return worst;
}

Message resolution_sentence(const std::vector<PressResiduals>& contacts, const Halo& halo) {
  const auto worst = worst_resolution(contacts);
  if (!worst) return {};
  const Message figures = en::say(
      "two points are resolved from {:.2f} mm on; depth is right within a tenth on walls of "
      "{:.2f} mm, on pins of {:.2f} mm and {:.2f} mm from a step",
      worst->two_points_mm, worst->wall_mm, worst->pin_mm, worst->step_mm);
  return halo.is_seen ? en::say("{}, if light does not scatter sideways", figures) : figures;
}

}  // namespace alltact
