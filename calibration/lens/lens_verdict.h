// The verdict on a lens calibration, in millimetres at the finger and in words.
#pragma once

#include "calibration/lens/lens_coverage.h"
#include "calibration/lens/lens_judge.h"
#include "calibration/verdict/verdict.h"

#include <optional>

namespace alltact {

struct LensEvidence {
  double focal_sd_part = 0;  ///< relative standard deviation of the focal length, of the worse axis
  double distance_mm = 0;    ///< of the finger
  double focal_px = 0;
  double sigma_px = 0;  ///< of the fit
  std::optional<HeldOut> held_out;
  std::optional<LensDifference> halves;
  LensCoverage coverage;
};

/// Limits of the error of a distance at the finger for a good, or a usable, lens.
inline constexpr double kGoodLensMm = 0.1;
inline constexpr double kUsableLensMm = 0.3;

/// error_mm: the standard deviation of a distance at the finger by the lens alone. The grade is the
/// worst of all evidence; without held-out views it is unproven.
[[nodiscard]] Verdict lens_verdict(const LensEvidence& evidence);

}  // namespace alltact
