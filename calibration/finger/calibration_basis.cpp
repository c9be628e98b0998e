#include "calibration/finger/calibration_basis.h"

#include "calibration/verdict/press_coverage.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr int kDomainSteps = 12;

}  // namespace

double scale_sd_mm(const MappingParameters& parameters) {
  const auto mapping = Mapping::create(parameters);
  if (!mapping || parameters.covariance.size() == 0) return 0;
  double squares = 0;
  for (int i = 1; i <= kDomainSteps; ++i) {
    const double sd_mm = mapping->depth_sd_mm(mapping->x_max() * i / kDomainSteps);
    squares += sd_mm * sd_mm / kDomainSteps;
  }
  return std::isfinite(squares) ? std::sqrt(squares) : 0.0;
}

CalibrationBasis basis_of(const FingerCalibration& done) {
  CalibrationBasis basis;
  const Calibration& calibration = done.calibration;
  const Face& face = done.finger.face;
  basis.layer_mm = face.layer_mm;
  basis.width_mm = face.width_mm;
  basis.plane_z_mm = face.plane_z_mm;
  basis.camera = camera_fingerprint(done.finger.camera);
  basis.reference = done.inputs.reference_checksum;
  for (const BallFit& ball : calibration.balls) {
    basis.ball_radii_mm.push_back(ball.radius_mm);
    basis.shallowest_mm =
        basis.shallowest_mm > 0 ? std::min(basis.shallowest_mm, ball.depth_mm) : ball.depth_mm;
    basis.deepest_mm = std::max(basis.deepest_mm, ball.depth_mm);
  }
  // 0 stands for an external measure of the scale: a punch with a step, or a measured depth.
  const bool has_measured_depth =
      std::any_of(calibration.balls.begin(), calibration.balls.end(), [](const BallFit& ball) {
        return ball.given_depth.has_value();
      });
  if (!calibration.steps.empty() || has_measured_depth) basis.ball_radii_mm.push_back(0);
  std::sort(basis.ball_radii_mm.begin(), basis.ball_radii_mm.end());
  basis.ball_radii_mm.erase(std::unique(basis.ball_radii_mm.begin(), basis.ball_radii_mm.end()),
                            basis.ball_radii_mm.end());
  std::vector<ContactSpot> spots;
  for (const PressResiduals& press : done.residuals)
    spots.push_back(
        {press.along_mm, press.across_mm, press.contact_radius_mm, press.face_length_mm});
  const PressCoverage coverage = coverage_of(std::move(spots));
  basis.positions = coverage.positions;
  basis.thirds = coverage.thirds;
  basis.position_leverage = coverage.leverage;
  basis.scale_sd_mm = scale_sd_mm(calibration.mapping);
  basis.pixel_sd_mm = done.pixel_sd_mm;
  basis.halo_mm = done.halo.is_seen ? done.halo.excess_mm : 0.0;
  if (calibration.radius_sensitivity)
    basis.depth_per_radius = 100 * calibration.radius_sensitivity->depth_part;
  basis.left_out = done.failed_presses;
  basis.is_complete = done.is_complete;
  for (const Contradiction& one : done.contradictions)
    basis.contradictions.push_back(recorded(one));
  return basis;
}

}  // namespace alltact
