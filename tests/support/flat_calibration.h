// How a flat finger is calibrated without the program.
#pragma once

#include "calibration/finger/calibrate_finger.h"
#include "tests/support/flat_finger.h"

namespace alltact::test {

/// With all its presses, as FlatFinger::calibrate() does by the command line.
inline FingerCalibrationInput flat_calibration(const FlatFinger& flat) {
  FingerCalibrationInput input;
  input.folder = flat.finger();
  input.presses.files.assign(flat.presses.begin(), flat.presses.end());
  input.press_set.ball_radius_mm = 4;
  input.reference = flat.file("ref.png");
  input.program_version = "0.1.0";
  return input;
}

}  // namespace alltact::test
