// How a calibration settles, round by round.
#pragma once

#include <functional>

namespace alltact {

/// How far the joint solution has come.
struct Round {
  int number = 1;          ///< from 1; begins anew with each stretch of the calculation
  double residual_mm = 0;  ///< mean absolute inside the contacts, of the solution so far
  double change_mm = 0;    ///< how much the unknowns moved in this round
};

/// Called on the calibrating thread, which waits for it. Empty where nobody wants to know: what a
/// round costs to tell is not worked out then.
using RoundListener = std::function<void(const Round& round)>;

}  // namespace alltact
