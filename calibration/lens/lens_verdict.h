// The verdict on a lens calibration and its evidence: coverage of the image, held-out views,
// halves.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "calibration/verdict/verdict.h"
#include "core/base/message.h"

#include <optional>
#include <vector>

namespace alltact {

// Coverage of the image and of tilts by the views, and missing views.

/// The tilt of the board's normal against the line of sight to its middle. The vector gives the
/// direction in which the normal towards the camera leans: x to the right, y down; its length is
/// the angle, degrees.
[[nodiscard]] Eigen::Vector2d tilt_deg(const BoardView& view, const BoardPose& pose);

struct LensCoverage {
  double seen_part = 0;           ///< of 6 x 4 cells of the image, those with a corner
  std::vector<Message> unseen;    ///< thirds of the image ("right edge", "top left corner")
  int tilted_views = 0;           ///< by 15 degrees or more
  std::vector<Message> untilted;  ///< directions in which no view is tilted ("to the left", "up")
  bool enough =
      false;  ///< ten views, four of them tilted in three directions, no edge nor the middle unseen
  Message advice;  ///< "three more, tilted to the left, near the right edge"; empty: none needed
};

/// Views needed for full coverage.
inline constexpr int kEnoughViews = 10;

/// Corners that the fit left out do not count.
[[nodiscard]] LensCoverage coverage_of(const std::vector<BoardView>& views, const LensFit& fit);

// Validation of a lens: on held-out views, and between halves of the views. The residual of the fit
// itself does not measure this.

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
                                                    const LensFitOptions& options, const Job& job);

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
    const std::vector<BoardView>& views, const LensFit& fit, const LensFitOptions& options,
    double distance_mm, const Job& job);

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
