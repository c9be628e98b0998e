#include "calibration/report/calibration_faults.h"

#include <algorithm>
#include <cmath>

namespace alltact {

std::vector<Message> fault_signs(const std::vector<PressSign>& presses) {
  std::vector<Message> signs;
  if (presses.empty()) return signs;
  const auto n = static_cast<double>(presses.size());
  double mean = 0, squares = 0;
  for (const PressSign& press : presses) mean += press.light_change / n;
  for (const PressSign& press : presses)
    squares += (press.light_change - mean) * (press.light_change - mean);
  const double sd = n > 1 ? std::sqrt(squares / (n - 1)) : 0.0;
  if (presses.size() > 2 && sd > kUnsteadyLight) {
    signs.push_back(en::say(
        "the brightness of the untouched face changes from press to press (standard deviation "
        "{:.1f} %): exposure or gain is automatic, or the room's light gets in; lock them, shade "
        "the finger and press again",
        100 * sd));
  } else if (std::abs(mean) > kOtherLight) {
    const Message how = mean > 0 ? en::say("brighter") : en::say("darker");
    signs.push_back(
        en::say("the untouched face is {:.1f} % {} in all presses than in the reference: light, "
                "exposure or gain has changed in between; the depth is corrected for smooth "
                "changes, but let the lamps warm up and record the reference again",
                100 * std::abs(mean), how));
  }
  const auto unknown = std::count_if(presses.begin(), presses.end(),
                                     [](const PressSign& press) { return !press.known_pose; });
  if (2 * unknown > static_cast<std::ptrdiff_t>(presses.size()))
    signs.push_back(
        en::say("in {} of {} presses the finger has a bend that the reference recording does not "
                "contain, or it has moved in its mount since: record a reference that bends as "
                "far, or press with less bending",
                unknown, presses.size()));
  return signs;
}

}  // namespace alltact
