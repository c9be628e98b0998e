// Validation of a lens: on held-out views, and between halves of the views. The residual of the fit
// itself does not measure this.
#pragma once

#include "calibration/lens/lens_fit.h"

#include <optional>
#include <vector>

namespace alltact {

struct HeldOut {
  int folds = 0;
  double error_px = 0;  ///< of one coordinate, in held-out views, with only their pose fitted
  double fx_sd_px = 0, fy_sd_px = 0;  ///< scatter between the folds (jackknife over groups)
};

/// Fits again without each of up to five groups of views, and evaluates that lens on the group.
/// `fit` is the solution with all views and the start. nullopt with fewer than four views, and when
/// stopped.
[[nodiscard]] std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views,
                                                    const LensFit& fit,
                                                    const LensFitOptions& options,
                                                    const Job& job);

/// Disagreement of two lenses on projected points, px, over the image.
struct LensDifference {
  double median_px = 0, worst_px = 0;
};

/// Points that `a` sees at two thirds and at four thirds of the distance are projected by `b` with
/// its best fitting pose. A difference that only moves or turns the camera is none. (As mrcal
/// compares projections.) nullopt when a lens folds over in the image.
[[nodiscard]] std::optional<LensDifference> difference_of(const CameraParameters& a,
                                                          const CameraParameters& b,
                                                          double distance_mm);

/// The difference of the lenses fitted to every second view and to the others. nullopt with fewer
/// than six views, when a half cannot be fitted, and when stopped.
[[nodiscard]] std::optional<LensDifference> difference_of_halves(
    const std::vector<BoardView>& views,
    const LensFit& fit,
    const LensFitOptions& options,
    double distance_mm,
    const Job& job);

}  // namespace alltact
