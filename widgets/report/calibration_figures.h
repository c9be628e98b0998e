// What the plots of a calibration show, taken from its figures. For the report and for the Studio.
#pragma once

#include "calibration/joint/calibrate.h"
#include "calibration/report/press_residuals.h"
#include "widgets/plots/face_map_plot.h"
#include "widgets/plots/mapping_plot.h"
#include "widgets/plots/press_error_plot.h"

#include <string>
#include <vector>

namespace alltact {

/// `chosen_press` stands out; empty: none.
[[nodiscard]] MappingPlotData mapping_figure(const Calibration& calibration,
                                             const std::vector<PressResiduals>& residuals,
                                             const std::string& chosen_press = {});

[[nodiscard]] std::vector<PressError> press_errors(const Calibration& calibration);

enum class FaceQuantity {
  kResidual = 1,  ///< mean magnitude of the residuals of a cell
  kHeldOut,       ///< error of the presses there, each left out in turn
  kDepthSd,       ///< standard deviation of the depth read there, as the fit knows its own curve
  kCoverage,      ///< how deep the presses there went
};
/// In mm, over what the presses showed of the face; the contacts as circles, in the order of the
/// residuals.
[[nodiscard]] FaceMapData face_figure(FaceQuantity quantity,
                                      const Calibration& calibration,
                                      const std::vector<PressResiduals>& residuals,
                                      FaceKind kind,
                                      const std::string& chosen_press = {});

/// Signed, from the inner part of every contact, mm.
[[nodiscard]] std::vector<double> all_errors(const std::vector<PressResiduals>& residuals);

}  // namespace alltact
