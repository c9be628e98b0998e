#include "core/sensing/contact/tip_displacement.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kSteps = 4;  // each reduces the residual to a tenth
constexpr double kMinInformation =
    1e-6;                             // smallest share of the smaller of both motions' information
constexpr double kModelPart = 0.005;  // of the displacement: error of modes and face
// Prior of q2 / q1: -0.9 to -0.5 in an even beam that is pushed from its base to its tip, -1.3 to
// 0.1 in beams that taper to a quarter.
constexpr double kTypicalRatio = -0.6, kRatioSd = 0.6;

}  // namespace

std::optional<TipDisplacement> tip_displacement(const Markers& markers,
                                                const std::vector<Eigen::Vector2d>& rest,
                                                const FaceShape& shape,
                                                const Eigen::MatrixXd& displacement_cov_px2) {
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || markers.empty() || displacement_cov_px2.rows() != size)
    return std::nullopt;
  const auto body = BodyMarkers::create(markers, shape);
  if (!body) return std::nullopt;
  const Eigen::VectorXd now = body->pixels_before(BeamModes::Zero());
  const Eigen::MatrixXd motions = body->motions_px(BeamModes::Zero());
  Eigen::VectorXd displacements_px =
      Eigen::VectorXd::Zero(size);  // from the current positions back to rest
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body->positions()[m].is_known)
      displacements_px.segment<2>(static_cast<Eigen::Index>(2 * m)) =
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  const Eigen::LLT<Eigen::MatrixXd> noise(displacement_cov_px2);
  if (noise.info() != Eigen::Success || !displacements_px.allFinite() || !motions.allFinite())
    return std::nullopt;
  const Eigen::MatrixXd weighted = noise.solve(motions);
  const Eigen::Matrix3d measured = motions.transpose() * weighted;
  if (!(measured(0, 0) * measured(2, 2) - measured(0, 2) * measured(0, 2) >
        kMinInformation * measured(0, 0) * measured(2, 2)))
    return std::nullopt;

  const BeamModes prior(-kTypicalRatio, 1, 0);
  BeamModes q_mm = BeamModes::Zero();
  Eigen::Matrix3d information;
  Eigen::VectorXd left = displacements_px;
  for (int step = 0; step < kSteps; ++step) {
    const double displacement_mm = std::max(1.0, std::hypot(q_mm[0], q_mm[2]));
    const double prior_weight = 1 / std::pow(kRatioSd * displacement_mm, 2);
    information = measured + prior_weight * prior * prior.transpose();
    q_mm += information.inverse() *
            (weighted.transpose() * left - prior_weight * prior.dot(q_mm) * prior);
    left = displacements_px - (body->pixels_before(q_mm) - now);
    if (!q_mm.allFinite() || !left.allFinite()) return std::nullopt;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  TipDisplacement result;
  result.displacement_mm = {-q_mm[0], q_mm[2]};
  result.covariance_mm2 << covariance(0, 0), -covariance(0, 2), -covariance(0, 2), covariance(2, 2);
  result.covariance_mm2 +=
      std::pow(kModelPart, 2) * result.displacement_mm.squaredNorm() * Eigen::Matrix2d::Identity();
  result.towards_back = body->towards_back();
  result.modes_mm = q_mm;
  return result;
}

}  // namespace alltact
