// Plot data of a calibration, for the report and for the Studio.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/report/press_errors.h"
#include "widgets/plots/calibration_plots.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/press_plots.h"

#include <string>
#include <vector>

namespace alltact {

/// `chosen_press` is highlighted; empty: none.
[[nodiscard]] MappingPlotData mapping_figure(const Calibration& calibration,
                                             const std::vector<PressResiduals>& residuals,
                                             const std::string& chosen_press = {});

[[nodiscard]] std::vector<PressError> press_errors(const Calibration& calibration);

enum class FaceQuantity {
  kResidual = 1,  ///< mean magnitude of the residuals of a cell
  kHeldOut,       ///< error of the presses there, each left out in turn
  kDepthSd,       ///< standard deviation of the depth there, by the covariance of the fit
  kCoverage,      ///< greatest depth of the presses there
};
/// In mm, over the part of the face that the presses showed; the contacts as circles, in the order
/// of the residuals.
[[nodiscard]] FaceMapData face_figure(FaceQuantity quantity, const Calibration& calibration,
                                      const std::vector<PressResiduals>& residuals, FaceKind kind,
                                      const std::string& chosen_press = {});

/// Signed, from the inner part of every contact, mm.
[[nodiscard]] std::vector<double> all_errors(const std::vector<PressResiduals>& residuals);

}  // namespace alltact
