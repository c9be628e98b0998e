#include "core/sensing/contact/tip_way.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr int kSteps = 4;             // each leaves a tenth of what is left
constexpr double kWellTold = 1e-6;    // least share of the smaller of both motions' information
constexpr double kModelPart = 0.005;  // of the way, that modes and face leave
// Of q2 by q1: -0.9 to -0.5 in an even beam that is pushed from its base to its tip, -1.3 to 0.1 in
// ones that taper to a quarter.
constexpr double kUsualRatio = -0.6, kRatioSd = 0.6;

}  // namespace

std::optional<TipWay> tip_way(const Markers& markers,
                              const std::vector<Eigen::Vector2d>& rest,
                              const FaceShape& shape,
                              const Eigen::MatrixXd& ways_px2) {
  const auto size = static_cast<Eigen::Index>(2 * markers.size());
  if (markers.size() != rest.size() || markers.empty() || ways_px2.rows() != size)
    return std::nullopt;
  const auto body = BodyMarkers::create(markers, shape);
  if (!body) return std::nullopt;
  const Eigen::VectorXd now = body->seen_before(BeamModes::Zero());
  const Eigen::MatrixXd motions = body->motions_px(BeamModes::Zero());
  Eigen::VectorXd ways = Eigen::VectorXd::Zero(size);  // back to rest
  for (std::size_t m = 0; m < markers.size(); ++m)
    if (body->places()[m].is_known)
      ways.segment<2>(static_cast<Eigen::Index>(2 * m)) =
          rest[m] - Eigen::Vector2d(markers[m].u, markers[m].v);
  const Eigen::LLT<Eigen::MatrixXd> noise(ways_px2);
  if (noise.info() != Eigen::Success || !ways.allFinite() || !motions.allFinite())
    return std::nullopt;
  const Eigen::MatrixXd weighted = noise.solve(motions);
  const Eigen::Matrix3d told = motions.transpose() * weighted;
  if (!(told(0, 0) * told(2, 2) - told(0, 2) * told(0, 2) > kWellTold * told(0, 0) * told(2, 2)))
    return std::nullopt;

  const BeamModes usual(-kUsualRatio, 1, 0);
  BeamModes q_mm = BeamModes::Zero();
  Eigen::Matrix3d information;
  Eigen::VectorXd left = ways;
  for (int step = 0; step < kSteps; ++step) {
    const double way_mm = std::max(1.0, std::hypot(q_mm[0], q_mm[2]));
    const double believed = 1 / std::pow(kRatioSd * way_mm, 2);
    information = told + believed * usual * usual.transpose();
    q_mm +=
        information.inverse() * (weighted.transpose() * left - believed * usual.dot(q_mm) * usual);
    left = ways - (body->seen_before(q_mm) - now);
    if (!q_mm.allFinite() || !left.allFinite()) return std::nullopt;
  }
  const Eigen::Matrix3d covariance = information.inverse();
  TipWay result;
  result.way_mm = {-q_mm[0], q_mm[2]};
  result.covariance_mm2 << covariance(0, 0), -covariance(0, 2), -covariance(0, 2), covariance(2, 2);
  result.covariance_mm2 +=
      std::pow(kModelPart, 2) * result.way_mm.squaredNorm() * Eigen::Matrix2d::Identity();
  result.towards_back = body->towards_back();
  result.modes_mm = q_mm;
  return result;
}

}  // namespace alltact
