// What a lens is worth: on views that it was not fitted to, and between halves of the views. The
// residual of the fit itself says nothing of that.
#pragma once

#include "calibration/lens/lens_fit.h"

#include <optional>
#include <vector>

namespace alltact {

struct HeldOut {
  int folds = 0;
  double error_px = 0;  ///< of one coordinate, in views left out, their pose alone fitted to them
  double fx_sd_px = 0, fy_sd_px = 0;  ///< by how far the folds disagree (jackknife over groups)
};

/// Fits again without each of up to five groups of views, and looks at the group with that lens.
/// `fit` is the solution with all views and the start. nullopt with fewer than four views, and when
/// stopped.
[[nodiscard]] std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views,
                                                    const LensFit& fit,
                                                    const LensFitOptions& options,
                                                    const Job& job);

/// By how much two lenses disagree on where points are seen, px, over the picture.
struct LensDifference {
  double median_px = 0, worst_px = 0;
};

/// Points seen by `a`, at two thirds and at four thirds of the distance, seen by `b` from wherever
/// it sees them best: a difference that only moves or turns the camera is none. (As mrcal compares
/// projections.) nullopt when a lens folds over in the picture.
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
