// From the boards found in pictures to a lens and what it is worth.
#pragma once

#include "calibration/lens/lens_coverage.h"
#include "calibration/lens/lens_fit.h"
#include "calibration/lens/lens_judge.h"
#include "calibration/verdict/verdict.h"
#include "core/settings.h"

#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct LensSettings {
  BoardPattern pattern = BoardPattern::kChessboard;
  CameraModel model = CameraModel::kBrown;  ///< kBrown or kFisheye
  double distance_mm = 60;  ///< of the finger, for what the lens's error means there
  MarkerDictionary dictionary = MarkerDictionary::k4x4;
  double marker_part = 0.75;
};
[[nodiscard]] const std::vector<Setting<LensSettings>>& lens_settings();

/// Fewer views than this are refused; three unknown homographies are what a lens needs.
inline constexpr int kFewestViews = 3;

struct LensViewReport {
  std::string name;
  int corners = 0;
  int left_out = 0;     ///< corners that are outliers
  double error_px = 0;  ///< root mean square of one coordinate of the corners used
  double tilt_deg = 0;  ///< angle between board and line of sight, 0: straight
  Message put_aside;    ///< why this view is not used; empty: it is
};

struct LensCalibration {
  LensFit fit;                        ///< of `used`, in their order
  std::vector<BoardView> used;        ///< with dots where their true centres are seen
  std::vector<LensViewReport> views;  ///< all that were given, in name order
  std::optional<HeldOut> held_out;
  std::optional<LensDifference> halves;
  LensCoverage coverage;
  double focal_sd_part = 0;  ///< from the covariance, or from views left out where they say more
  Verdict verdict;
  std::vector<Message> remarks;  ///< what the user should know

  [[nodiscard]] double focal_sd_px() const { return focal_sd_part * fit.lens.fx_px; }
};

/// Views that show what another shows already are put aside, and so are those that do not agree
/// with the others, each with the reason. The order of the views does not matter. `size`: of the
/// pictures. Errors: too few views, all alike, no lens that explains them, a lens that folds over
/// inside the picture with any number of coefficients, stopped before there was a lens. A job
/// stopped later gives the lens without what was not judged yet.
[[nodiscard]] Result<LensCalibration> calibrate_lens(std::vector<BoardView> views,
                                                     cv::Size size,
                                                     const LensSettings& settings,
                                                     const Job& job);

/// The view with each dot where its true centre is seen, instead of the middle of its picture:
/// in perspective, and bent by a lens, a disc's picture is not centred on its centre's.
[[nodiscard]] BoardView without_dot_bias(const BoardView& view,
                                         const CameraParameters& lens,
                                         const BoardPose& pose,
                                         double dot_radius_mm);

}  // namespace alltact
