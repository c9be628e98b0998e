// Progress of the joint fit, round by round.
#pragma once

#include <functional>

namespace alltact {

/// State after one round of the joint fit.
struct Round {
  int number = 1;          ///< from 1; restarts with each stage of the calculation
  double residual_mm = 0;  ///< mean absolute inside the contacts, of the solution so far
  double change_mm = 0;    ///< how much the unknowns moved in this round
};

/// Called on the calibrating thread, which waits for it. Empty: the figures of a round are not
/// computed.
using RoundListener = std::function<void(const Round& round)>;

}  // namespace alltact
