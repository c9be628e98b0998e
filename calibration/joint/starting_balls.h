// Start of a calibration: each press's ball, found alone or set by a person, and the press's
// samples around it.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// A press with its ball.
struct FoundBall {
  const Press* press;
  BallGuess guess;
  PressSamples fine, coarse;   ///< for the solution; for the choice of the model
  double tangent_arc_deg = 0;  ///< of the outline that entered the fit
};

/// Finds the balls of all presses but punches, in an order that depends only on the measurements.
/// `unusable` receives a sentence without full stop for each other press: no ball to be found, the
/// same image as another press, too few samples in the contact. A stopped job ends it early.
[[nodiscard]] std::vector<FoundBall> find_balls(const std::vector<Press>& presses,
                                                const Face& face,
                                                const Job& job,
                                                std::vector<Message>* unusable);

}  // namespace alltact
