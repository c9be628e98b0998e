// A patch of the measured contact face and its measurands with standard deviations.
//
// Every standard deviation has two parts. Noise is that of single pixels, which smoothing spreads
// over `noise_pixels` of them; many pixels average it out. The uncertainty of mapping, reference
// and light is common to neighbours. It is propagated by a second measurement with all depths
// shifted by it.
#pragma once

#include "core/base/result.h"
#include "core/finger/mapping.h"
#include "core/sensing/frame_result.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace alltact {

/// A value with its standard deviation, in the same unit.
struct MeasuredValue {
  double value = 0, sd = 0;
};

struct SurfacePoint {
  Eigen::Vector3d untouched_mm;  ///< camera frame, of the unloaded contact face
  double depth_mm = 0;           ///< along z; the contact face is at untouched - (0, 0, depth)
  double noise_mm = 0, common_mm = 0;  ///< standard deviations of the depth
  bool is_limit = false;               ///< the depth is only a lower or upper bound (depth_map.h)
  double on_face_mm2 = 0,
         projected_mm2 = 0;  ///< area of the pixel on the untouched face, and projected along z

  [[nodiscard]] Eigen::Vector3d point_mm() const {
    return untouched_mm - Eigen::Vector3d(0, 0, depth_mm);
  }
};

struct SurfacePatch {
  std::vector<SurfacePoint> points;
  double noise_pixels = 1;  ///< neighbouring pixels with correlated noise; at least 1
};

/// Correlation area of white noise that a Gaussian with this standard deviation has smoothed: the
/// sum of its autocorrelation, 4 pi sd^2; for a single row of pixels 2 sqrt(pi) sd; at least 1.
[[nodiscard]] double noise_pixels_of_area(double smoothing_px);
[[nodiscard]] double noise_pixels_of_row(double smoothing_px);

/// Ball whose cap is the deepest part of a patch. Geometric fit, weighted by the noise, to the
/// points at least half as deep as the deepest: the skin lifts off a ball further out.
struct FittedBall {
  Eigen::Vector3d centre_mm;  ///< camera frame
  MeasuredValue radius_mm;
  double residual_mm = 0;  ///< root of the mean square
  std::size_t points = 0;
};
/// Points at a limit are excluded. Errors: fewer than 30 points remain; they lie in a plane, or
/// determine the radius to no better than half of itself.
[[nodiscard]] Result<FittedBall> fit_ball(const SurfacePatch& patch);

/// Properties of the part that is deeper than `threshold_mm`.
struct PressedSurface {
  MeasuredValue area_mm2;    ///< on the untouched face
  MeasuredValue volume_mm3;  ///< displaced along z
  MeasuredValue mean_mm;     ///< depth, by area
  bool is_lower_bound =
      false;  ///< some points are at a limit: volume and mean depth are lower bounds
};
/// Error: no point is deeper.
[[nodiscard]] Result<PressedSurface> pressed_part(const SurfacePatch& patch, double threshold_mm);

/// Which part of a patch is its form and its waviness, neither of which is roughness (ISO 25178-3).
struct RoughnessFilter {
  int form_degree = 2;  ///< of the polynomial that is removed as the form, 1 to 4; 1: a plane
  /// Wavelengths above it do not count (Gaussian L-filter, ISO 16610-61: half of the amplitude
  /// passes at lambda_c). Empty: all count that are not form.
  std::optional<double> lambda_c_mm;
  bool operator==(const RoughnessFilter&) const = default;
};
inline constexpr int kMaxFormDegree = 4;

/// Heights of a patch above its form, so that bends of the finger and of the pressing object do not
/// count.
struct Roughness {
  /// Root mean square height with the noise subtracted; 0: within the noise. Its sd is the larger
  /// one of the two sides, which differ near 0.
  MeasuredValue sq_mm;
  double sz_mm = 0;     ///< from the lowest to the highest, noise included
  double noise_mm = 0;  ///< result for a perfectly smooth skin
};
/// Errors: fewer than 30 points, or too narrow for the form; a point at a limit; lambda_c below
/// five pixels, or above the patch's own length.
[[nodiscard]] Result<Roughness> roughness(const SurfacePatch& patch,
                                          const RoughnessFilter& filter = {});

/// A plane fitted to the contact face within a patch.
struct FittedPlane {
  Eigen::Vector3d normal;           ///< unit, towards the camera
  Eigen::Matrix3d covariance;       ///< of the normal, from noise
  Eigen::Vector3d normal_if_moved;  ///< with all depths shifted by their common standard deviation
};
/// Errors: fewer than 10 points, or all on one line; a point at a limit.
[[nodiscard]] Result<FittedPlane> fit_plane(const SurfacePatch& patch);
/// Angle between two planes, degrees in [0, 180].
[[nodiscard]] MeasuredValue angle_deg(const FittedPlane& a, const FittedPlane& b);

/// A step of the depths along a line: two parallel straight lines, before and after the best
/// position of the step. A tenth of the length around it is excluded (ISO 5436 excludes a third).
/// The step needs two planes:
/// - each side has at least a tenth of the line and 4 points, none of them at a limit;
/// - each side is straight: residuals of its own line are within 1.5 times the noise (of as many
///   independent pixels as it has), or a twentieth of the step;
/// - both are parallel: their slopes differ by less than 4 sd, or by less than a tenth of the step
///   over half of the line.
struct StepHeight {
  MeasuredValue height_mm;  ///< second less first
  double at_mm = 0;         ///< along the line
};
/// `along_mm`: ascending, one value for each point. Errors: fewer than 12 points; no step above the
/// noise; not two planes, with the reason.
[[nodiscard]] Result<StepHeight> step_height(const SurfacePatch& line,
                                             const std::vector<double>& along_mm);

// Point, profile and distance measurements on a measured face.

/// Bilinear interpolation between four pixels. `image`: CV_32FC1. NaN where a neighbour has no
/// value or lies outside.
[[nodiscard]] float bilinear_value(const cv::Mat& image, double u, double v);

/// The contact face at a sub-pixel position.
struct FaceSample {
  cv::Point2d pixel;
  Eigen::Vector3d untouched_mm;    ///< of the unloaded contact face
  std::optional<double> depth_mm;  ///< along z; empty where it was not measured
  std::optional<double> sd_mm;     ///< of the depth
  std::uint8_t flag = kMeasured;   ///< why depth is missing or doubtful
  /// On the contact face. Without a depth: on the untouched face.
  [[nodiscard]] Eigen::Vector3d point_mm() const {
    return untouched_mm - Eigen::Vector3d(0, 0, depth_mm.value_or(0));
  }
};

/// nullopt off the face. `sd_mm`: as depth_sd_mm() returns it; may be empty.
[[nodiscard]] std::optional<FaceSample> sample_face(const FrameResult& result, const Face& face,
                                                    const cv::Mat& sd_mm, cv::Point2d pixel);

/// Distance between two points of the contact face.
struct Distance {
  double straight_mm = 0;
  double along_face_mm = 0;  ///< along the contact face, over the straight line in the image
  Eigen::Vector3d apart_mm;  ///< second less first
};

/// Depth along the straight line in the image from one position to another.
struct Profile {
  std::vector<cv::Point2d> pixels;
  std::vector<double> along_mm;  ///< path length over the untouched face from the first position
  std::vector<double> depth_mm;  ///< NaN where it was not measured
  std::vector<double> sd_mm;     ///< NaN where it is not known
};

/// Takes one step a pixel, at least two. Positions off the face are left out.
[[nodiscard]] Profile profile_between(const FrameResult& result, const Face& face,
                                      const cv::Mat& sd_mm, cv::Point2d from, cv::Point2d to);

/// nullopt where one of them is off the face.
[[nodiscard]] std::optional<Distance> distance_between(const FrameResult& result, const Face& face,
                                                       cv::Point2d from, cv::Point2d to);

// Distance between two points of the contact face, with its standard deviation.

/// Straight distance between the contact face's points at two pixels.
///
/// A point p errs along its line of sight r (r_z = 1) by the face's z, sd s (FaceColumn::z_sd_mm),
/// and along z by its depth, sd d. With the unit vector e from one to the other
///   var = (e.r1 s1)^2 + (e.r2 s2)^2 - 2 rho (e.r1 s1)(e.r2 s2) + e_z^2 (d1^2 + d2^2).
/// The face's z is a smooth curve along it, fitted to all columns, so that errors of neighbours are
/// correlated:
///   rho = exp(-(u2 - u1)^2 / (2 (w / 8)^2)),
/// w the width of the face in columns and 8 the number of coefficients of the default curve. Errors
/// of the lens model and of the face's width are not included.
///
/// `sd_mm`: of the depth, as depth_sd_mm() returns it. Errors: a position is off the face; both
/// positions are the same.
[[nodiscard]] Result<MeasuredValue> straight_distance(const FrameResult& result, const Face& face,
                                                      const cv::Mat& sd_mm, cv::Point2d from,
                                                      cv::Point2d to);

// Extracts patches of the contact face from a measured frame.

/// The pixels of `box` that have a depth. A large box is sampled at every second, third, ... pixel
/// in both directions, so that about 1500 remain. `smoothing_px`: setting of the measurement. Empty
/// where the frame has no depth.
[[nodiscard]] SurfacePatch patch_in(const FrameResult& result, const Face& face,
                                    const Mapping& mapping, double smoothing_px,
                                    const cv::Rect& box);

/// The pixels on a straight line in the image, each once, and their distance from the first one
/// along the untouched face.
struct SurfaceLine {
  SurfacePatch patch;
  std::vector<double> along_mm;
};
[[nodiscard]] SurfaceLine line_between(const FrameResult& result, const Face& face,
                                       const Mapping& mapping, double smoothing_px,
                                       cv::Point2d from, cv::Point2d to);

}  // namespace alltact
