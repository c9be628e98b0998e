// A piece of the measured contact face, and what can be measured of it with how sure that is.
//
// Every standard deviation here has two parts. Noise is that of single pixels, which smoothing
// spreads over `noise_pixels` of them: many pixels average it out. What the mapping, the reference
// and the light leave open is common to neighbours: it is carried through by measuring once more
// with all depths moved by it.
#pragma once

#include "core/result.h"

#include <cstddef>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// A value with one standard deviation, in the same unit.
struct MeasuredValue {
  double value = 0, sd = 0;
};

struct SurfacePoint {
  Eigen::Vector3d untouched_mm;  ///< camera frame, as if nothing pressed
  double depth_mm = 0;           ///< along z; the contact face is at untouched - (0, 0, depth)
  double noise_mm = 0, common_mm = 0;  ///< standard deviations of the depth
  bool is_limit = false;  ///< the depth is only a least or greatest value (pixel_flags.h)
  double on_face_mm2 = 0,
         flat_mm2 = 0;  ///< that the pixel covers of the untouched face, and along z

  [[nodiscard]] Eigen::Vector3d point_mm() const {
    return untouched_mm - Eigen::Vector3d(0, 0, depth_mm);
  }
};

struct SurfacePatch {
  std::vector<SurfacePoint> points;
  double noise_pixels = 1;  ///< neighbouring pixels that share their noise; at least 1
};

/// Of white noise that a Gaussian of this standard deviation has smoothed: the sum of its
/// autocorrelation, 4 pi sd^2, and of a single row of pixels, 2 sqrt(pi) sd; at least 1.
[[nodiscard]] double noise_pixels_of_area(double smoothing_px);
[[nodiscard]] double noise_pixels_of_row(double smoothing_px);

/// The ball whose cap the deepest part of a patch is: geometric fit, weighted by the noise, to the
/// points at least half as deep as the deepest (the skin lifts off a ball further out).
struct FittedBall {
  Eigen::Vector3d centre_mm;  ///< camera frame
  MeasuredValue radius_mm;
  double residual_mm = 0;  ///< root of the mean square
  std::size_t points = 0;
};
/// Points at a limit are left out. Errors: fewer than 30 points there; they lie in a plane, or hold
/// the radius to no better than half of itself.
[[nodiscard]] Result<FittedBall> fit_ball(const SurfacePatch& patch);

/// Of what is deeper than `threshold_mm`.
struct PressedSurface {
  MeasuredValue area_mm2;    ///< on the untouched face
  MeasuredValue volume_mm3;  ///< displaced along z
  MeasuredValue mean_mm;     ///< depth, by area
  bool is_least = false;     ///< some points are at a limit: volume and mean depth are least values
};
/// Error: nothing is.
[[nodiscard]] Result<PressedSurface> pressed_part(const SurfacePatch& patch, double threshold_mm);

/// Heights above the second-degree surface through a patch: its form is taken out, as ISO 25178 has
/// it, so bends of the finger and of what presses do not count.
struct Roughness {
  /// Root of the mean square, what noise adds taken off again; 0: within the noise. Its sd is the
  /// larger of both sides', which differ near 0.
  MeasuredValue sq_mm;
  double sz_mm = 0;     ///< from the lowest to the highest, noise included
  double noise_mm = 0;  ///< what a perfectly smooth skin would show
};
/// Errors: fewer than 30 points, or in one line; one of them is at a limit.
[[nodiscard]] Result<Roughness> roughness(const SurfacePatch& patch);

/// A plane, as the contact face has it within a patch.
struct FittedPlane {
  Eigen::Vector3d normal;           ///< unit, towards the camera
  Eigen::Matrix3d covariance;       ///< of the normal, from noise
  Eigen::Vector3d normal_if_moved;  ///< with all depths moved by what is common
};
/// Errors: fewer than 10 points, or in one line; one of them is at a limit.
[[nodiscard]] Result<FittedPlane> fit_plane(const SurfacePatch& patch);
/// Between two planes, degrees in [0, 180].
[[nodiscard]] MeasuredValue angle_deg(const FittedPlane& a, const FittedPlane& b);

/// A step of the depths along a line: two parallel straight lines, one before and one after the
/// place where they fit best, a tenth of the length around it left out (ISO 5436 leaves a third).
/// It needs two planes:
/// - each side has a tenth of the line and 4 points at least, none of them at a limit;
/// - each side is straight: a line of its own leaves no more than 1.5 times the noise (of as many
///   independent pixels as it has), or a twentieth of the step;
/// - both are parallel: their slopes differ by less than 4 sd, or by so little that over half of
/// the
///   line it makes less than a tenth of the step.
struct StepHeight {
  MeasuredValue height_mm;  ///< second less first
  double at_mm = 0;         ///< along the line
};
/// `along_mm` ascending, one for each point. Errors: fewer than 12 points; no step that stands out
/// of the noise; not two planes, with what is missing.
[[nodiscard]] Result<StepHeight> step_height(const SurfacePatch& line,
                                             const std::vector<double>& along_mm);

}  // namespace alltact
