// Simulated calibrations with a known fault, for the rules that detect it (calibration_faults.h)
// and for the report's pictures of typical faults.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/report/calibration_faults.h"
#include "calibration/report/press_errors.h"
#include "core/base/job.h"

#include <cstdint>
#include <vector>

namespace alltact {

enum class Fault {
  kNone = 1,
  kWrongRadius,        ///< given 10 % too large
  kMovedCamera,        ///< moved by a few pixels between reference and presses
  kAutomaticExposure,  ///< another gain in every press, within 6 %
  kBrighterLight,      ///< 5 % more light than in the reference
  kLooseSkin,          ///< the skin leaves the ball early and bulges brightly around it
};

struct SimulatedCalibration {
  Calibration calibration;
  std::vector<PressResiduals> residuals;
  std::vector<PressSign> signs;
};

/// Four presses of a 4 mm ball on a small flat sensor (240 x 180 px, 0.1 mm a pixel), through the
/// same pipeline and calibration as real ones. correct_light: the pipeline's default; without it
/// the fault shows uncorrected. About 0.1 s. Errors: the job was stopped.
[[nodiscard]] Result<SimulatedCalibration> simulate_calibration(Fault fault, std::uint64_t seed,
                                                                bool correct_light, const Job& job);

}  // namespace alltact
