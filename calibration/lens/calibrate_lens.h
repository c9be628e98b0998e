// From boards found in images to a lens, its verdict and its record.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "calibration/lens/lens_verdict.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/settings.h"
#include "core/finger/finger.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace alltact {

struct LensSettings {
  BoardPattern pattern = BoardPattern::kChessboard;
  CameraModel model = CameraModel::kBrown;  ///< kBrown or kFisheye
  double distance_mm = 60;                  ///< of the finger, where the lens's error is evaluated
  MarkerDictionary dictionary = MarkerDictionary::k4x4;
  double marker_part = 0.75;
};
[[nodiscard]] const std::vector<Setting<LensSettings>>& lens_settings();

/// Minimum number of views: a lens needs three homographies.
inline constexpr int kFewestViews = 3;

struct LensViewReport {
  std::string name;
  int corners = 0;
  int left_out = 0;     ///< corners that are outliers
  double error_px = 0;  ///< root mean square of one coordinate of the used corners
  double tilt_deg = 0;  ///< angle between the board's normal and the line of sight
  Message rejection;    ///< why this view is rejected; empty: it is used
};

struct LensCalibration {
  LensFit fit;                        ///< of `used`, in their order
  std::vector<BoardView> used;        ///< with dots at their true centres
  std::vector<LensViewReport> views;  ///< all that were given, in name order
  std::optional<HeldOut> held_out;
  std::optional<LensDifference> halves;
  LensCoverage coverage;
  double focal_sd_part = 0;  ///< from the covariance, or from held-out views where they give more
  Verdict verdict;
  std::vector<Message> remarks;  ///< for the user

  [[nodiscard]] double focal_sd_px() const { return focal_sd_part * fit.lens.fx_px; }
};

/// Rejects views that repeat another, and views that contradict the others, each with the reason.
/// The order of the views does not matter. `size`: of the images. Errors: too few views, all alike,
/// no lens that explains them, a lens that folds over inside the image with any number of
/// coefficients, stopped before there was a lens. A job stopped later returns the lens with the
/// judgement so far.
[[nodiscard]] Result<LensCalibration> calibrate_lens(std::vector<BoardView> views, cv::Size size,
                                                     const LensSettings& settings, const Job& job);

/// The view with each dot at its true centre instead of its centroid. In perspective, and with
/// distortion, a disc's centroid is not the image of its centre.
[[nodiscard]] BoardView without_dot_bias(const BoardView& view, const CameraParameters& lens,
                                         const BoardPose& pose, double dot_radius_mm);

// A lens calibration from files, and its record.

/// Finds the board in all images and calibrates the lens. Errors: those of open_source, find_boards
/// and calibrate_lens.
[[nodiscard]] Result<LensCalibration> measure_lens(const std::vector<std::filesystem::path>& inputs,
                                                   const Board& board, const LensSettings& settings,
                                                   const Job& job);

/// How a lens was measured, for the camera file.
[[nodiscard]] LensRecord lens_record(const Board& board, const LensCalibration& done);

}  // namespace alltact
