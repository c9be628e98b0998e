// A patch of the measured contact face and its measurands with standard deviations.
//
// Every standard deviation has two parts. Noise is that of single pixels, which smoothing spreads
// over `noise_pixels` of them; many pixels average it out. The uncertainty of mapping, reference
// and light is common to neighbours. It is propagated by a second measurement with all depths
// shifted by it.
#pragma once

#include "core/result.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A value with its standard deviation, in the same unit.
struct MeasuredValue {
  double value = 0, sd = 0;
};

struct SurfacePoint {
  Eigen::Vector3d untouched_mm;  ///< camera frame, of the unloaded contact face
  double depth_mm = 0;           ///< along z; the contact face is at untouched - (0, 0, depth)
  double noise_mm = 0, common_mm = 0;  ///< standard deviations of the depth
  bool is_limit = false;               ///< the depth is only a lower or upper bound (pixel_flags.h)
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

/// Heights above the second-degree surface through a patch. The form is removed as in ISO 25178, so
/// that bends of the finger and of the pressing object do not count.
struct Roughness {
  /// Root mean square height with the noise subtracted; 0: within the noise. Its sd is the larger
  /// one of the two sides, which differ near 0.
  MeasuredValue sq_mm;
  double sz_mm = 0;     ///< from the lowest to the highest, noise included
  double noise_mm = 0;  ///< result for a perfectly smooth skin
};
/// Errors: fewer than 30 points, or all on one line; a point at a limit.
[[nodiscard]] Result<Roughness> roughness(const SurfacePatch& patch);

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

}  // namespace alltact
