// Where the balls of a calibration start from: each press's ball as it is found by itself, or as a
// hand put it, and the press's samples around it.
#pragma once

#include "calibration/presses/press.h"
#include "calibration/presses/press_samples.h"
#include "core/finger/finger.h"
#include "core/job.h"
#include "core/message.h"

#include <vector>

namespace alltact {

/// A press whose ball was found.
struct FoundBall {
  const Press* press;
  BallGuess guess;
  PressSamples fine, coarse;   ///< for the solution; for choosing what to fit
  double tangent_arc_deg = 0;  ///< of the outline that entered the fit
};

/// The balls of all presses but punches, in an order that depends only on what was measured. Of the
/// others `unusable` says why, a sentence each without the full stop: no ball to be found, the same
/// picture as another press, too few samples in the contact. A stopped job ends it early.
[[nodiscard]] std::vector<FoundBall> find_balls(const std::vector<Press>& presses,
                                                const Face& face,
                                                const Job& job,
                                                std::vector<Message>* unusable);

}  // namespace alltact
