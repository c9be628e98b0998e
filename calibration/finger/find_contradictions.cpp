#include "calibration/finger/find_contradictions.h"

namespace alltact {

std::vector<Contradiction> find_contradictions(const FingerCalibration& done) {
  std::vector<Contradiction> all;
  Contradiction deeper;
  deeper.kind = ContradictionKind::kContactDeeperThanLayer;
  deeper.given_mm = done.finger.face.layer_mm;
  deeper.of = static_cast<int>(done.calibration.balls.size());
  for (const BallFit& ball : done.calibration.balls) {
    if (!(ball.depth_mm > deeper.given_mm)) continue;
    const bool is_first = deeper.presses.empty();
    deeper.presses.push_back(ball.press);
    deeper.measured_mm = is_first ? ball.depth_mm : std::min(deeper.measured_mm, ball.depth_mm);
    deeper.measured_to_mm = std::max(deeper.measured_to_mm, ball.depth_mm);
  }
  if (!deeper.presses.empty()) all.push_back(deeper);
  return all;
}

}  // namespace alltact
