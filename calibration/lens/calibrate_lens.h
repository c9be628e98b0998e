// From boards found in images to a lens, its verdict and its record.
#pragma once

#include "calibration/lens/lens_fit.h"
#include "calibration/verdict/verdict.h"
#include "core/base/job.h"
#include "core/base/result.h"
#include "core/base/settings.h"
#include "core/finger/finger.h"

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct LensSettings {
  BoardPattern pattern = BoardPattern::kChessboard;
  CameraModel model = CameraModel::kBrown;  ///< kBrown or kFisheye
  double distance_mm = 60;                  ///< of the finger, where the lens's error is evaluated
  MarkerDictionary dictionary = MarkerDictionary::kAny;
  double marker_part = 0.75;
  double tag_spacing = 0.3;

  /// The board with these settings.
  [[nodiscard]] Board applied_to(Board board) const;
};
[[nodiscard]] const std::vector<Setting<LensSettings>>& lens_settings();

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
  double error_px = 0;  ///< of one coordinate, in held-out views, with only their pose fitted
  /// Scatter of fx, fy, cx, cy between the folds (jackknife over groups).
  Eigen::Vector4d sd_px = Eigen::Vector4d::Zero();
};

/// Fits again without each of up to five groups of views, and evaluates that lens on the group.
/// `fit` is the solution with all views and the start. nullopt with fewer than four views, and when
/// stopped.
[[nodiscard]] std::optional<HeldOut> cross_validate(const std::vector<BoardView>& views,
                                                    const LensFit& fit, int coefficients,
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

/// Lenses fitted to halves of the views, each number in the order fx, fy, cx, cy.
struct HalvesComparison {
  LensDifference difference;               ///< every second view against the others
  std::array<Eigen::Vector4d, 2> numbers;  ///< of these two halves, px
  /// Their difference over the standard deviation that the two covariances predict for it.
  Eigen::Vector4d sigmas = Eigen::Vector4d::Zero();
  /// Root mean square of that over up to three independent splits. 1: the covariance is honest.
  Eigen::Vector4d scatter = Eigen::Vector4d::Zero();
};

/// nullopt with fewer than six views, when a half cannot be fitted, and when stopped.
[[nodiscard]] std::optional<HalvesComparison> compare_halves(const std::vector<BoardView>& views,
                                                             const LensFit& fit, int coefficients,
                                                             double distance_mm, const Job& job);

/// The board as a fit with free stretch and bend sees it.
struct BoardShape {
  double stretch = 0, stretch_sd = 0;          ///< squares are 1 + stretch times as wide as high
  double bend_mm = 0;                          ///< from the middle to the corners
  bool is_stretched = false, is_bent = false;  ///< significantly
  CameraParameters lens;                       ///< with this shape
  [[nodiscard]] bool has_defect() const { return is_stretched || is_bent; }
};

/// A defect is significant by the covariance alone: it may be what makes halves disagree.
/// `disagreement`: factor on the sd of the stretch that the covariance gives. nullopt with fewer
/// than six views, where the views do not determine the shape, and when stopped.
[[nodiscard]] std::optional<BoardShape> board_shape(const std::vector<BoardView>& views,
                                                    const LensFit& fit, int coefficients,
                                                    double disagreement, const Job& job);

/// Standard deviations of fx, fy, cx, cy, px. The covariance assumes independent errors of corners;
/// a board that is not flat or a lens that the model does not describe moves all corners of a view.
/// So the covariance's sd grows by the factor by which halves of the views disagree more than it
/// predicts (Birge's ratio), and is at least the scatter between folds. A defect of the board adds
/// the distance by which it moves the lens.
[[nodiscard]] Eigen::Vector4d lens_sd_px(const LensFit& fit, const std::optional<HeldOut>& held_out,
                                         const std::optional<HalvesComparison>& halves,
                                         const std::optional<BoardShape>& shape);

// From views to a lens.

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
  std::optional<HalvesComparison> halves;
  std::optional<BoardShape> shape;
  LensCoverage coverage;
  double focal_sd_part = 0;  ///< the larger sd of fx and fy, as a fraction
  Verdict verdict;
  std::vector<Message> remarks;  ///< for the user
};

/// Limits of the error of a distance at the finger for a good, or a usable, lens.
inline constexpr double kGoodLensMm = 0.1;
inline constexpr double kUsableLensMm = 0.3;

/// What makes fx and fy differ. Pixels of cameras are square. An image that is scaled in one
/// direction, or a board that is printed so, makes them differ.
enum class AspectCause {
  kNone = 1,   ///< they do not differ, by 1 % or 3 standard deviations
  kBoard,      ///< a stretched board explains the corners, with square pixels
  kImage,      ///< the views show that the board is square
  kUndecided,  ///< these views do not separate the two
};
struct PixelAspect {
  double ratio = 1;  ///< fx / fy
  AspectCause cause = AspectCause::kNone;
};
[[nodiscard]] PixelAspect pixel_aspect(const LensCalibration& calibration);

/// The verdict on the lens by its fit, coverage, held-out views and halves. error_mm: the standard
/// deviation of a distance at the finger, at `distance_mm`, by the lens alone. The grade is the
/// worst of all evidence; without held-out views it is unproven.
[[nodiscard]] Verdict lens_verdict(const LensCalibration& calibration, double distance_mm);

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
