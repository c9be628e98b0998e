#include "calibration/joint/joint_costs.h"

#include "core/geometry/ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <Eigen/Dense>

namespace alltact {

PressCost::PressCost(const WeightedPress& weighted, const MappingCurve& curve,
                     const JointOptions& options, bool lifts_off)
    : weighted_(weighted), curve_(curve), options_(options), lifts_off_(lifts_off) {
  set_num_residuals(static_cast<int>(weighted.samples.size()));
  mutable_parameter_block_sizes()->push_back(3);
  mutable_parameter_block_sizes()->push_back(curve.family().numbers());
  mutable_parameter_block_sizes()->push_back(1);
}

bool PressCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  const Eigen::Vector3d centre(parameters[0]);
  const int n = curve_.family().numbers();
  const double lift_mm = lifts_off_ ? std::exp(parameters[2][0]) : 0.0;
  const CurveAt curve = curve_.at(parameters[1]);
  std::array<double, 16> by_values{};
  for (std::size_t i = 0; i < weighted_.samples.size(); ++i) {
    const Sample& sample = *weighted_.samples[i];
    const double weight = weighted_.root_weight[i] * weighted_.slope_mm[i];
    Eigen::Vector3d by_centre;
    double by_lift = 0;
    const double depth = skin_depth_mm(sample, options_.along, centre, weighted_.ball_radius_mm,
                                       weighted_.plane, lift_mm, &by_centre, &by_lift);
    if (!std::isfinite(depth)) return false;
    const bool needs_values = jacobians != nullptr && jacobians[1] != nullptr;
    const auto [x, slope_mm] = curve.inverse(depth + weighted_.blur_mm[i], sample.unit_position,
                                             sample.x, needs_values ? by_values.data() : nullptr);
    if (!std::isfinite(x)) return false;
    residuals[i] = weight * (sample.x - x);
    if (jacobians == nullptr) continue;
    if (jacobians[0] != nullptr)
      Eigen::Map<Eigen::Vector3d>(jacobians[0] + 3 * i) = -weight / slope_mm * by_centre;
    if (jacobians[2] != nullptr) jacobians[2][i] = -weight / slope_mm * by_lift * lift_mm;
    if (needs_values)
      for (int k = 0; k < n; ++k)
        jacobians[1][static_cast<std::size_t>(n) * i + static_cast<std::size_t>(k)] =
            -weight * by_values[static_cast<std::size_t>(k)];
  }
  return true;
}

OutlineCost::OutlineCost(const WeightedPress& weighted) : weighted_(weighted) {
  set_num_residuals(static_cast<int>(weighted.outline.size()));
  mutable_parameter_block_sizes()->push_back(3);
}

bool OutlineCost::Evaluate(double const* const* parameters, double* residuals,
                           double** jacobians) const {
  const Eigen::Vector3d centre(parameters[0]);
  for (std::size_t i = 0; i < weighted_.outline.size(); ++i) {
    const double weight = weighted_.outline_root_weight[i];
    Eigen::Vector3d by_centre;
    const double angle = outline_angle_rad(weighted_.outline[i]->direction, centre,
                                           weighted_.ball_radius_mm, &by_centre);
    if (!std::isfinite(angle)) return false;
    residuals[i] = weight * angle;
    if (jacobians != nullptr && jacobians[0] != nullptr)
      Eigen::Map<Eigen::Vector3d>(jacobians[0] + 3 * i) = weight * by_centre;
  }
  const auto n = static_cast<Eigen::Index>(weighted_.outline.size());
  weighted_.damp_along_z(Eigen::Map<Eigen::VectorXd>(residuals, n));
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>> rows(jacobians[0], n, 3);
  for (int k = 0; k < 3; ++k) {
    Eigen::VectorXd column = rows.col(k);
    weighted_.damp_along_z(column);
    rows.col(k) = column;
  }
  return true;
}

bool GivenDepthCost::Evaluate(double const* const* parameters, double* residuals,
                              double** jacobians) const {
  const Eigen::Vector3d centre(parameters[0]);
  const double depth_mm = weighted_.ball_radius_mm - weighted_.plane.height_mm(centre);
  const double root_weight = kRootWeightOfKnown / weighted_.given_depth->sd_mm;
  residuals[0] = root_weight * (depth_mm - weighted_.given_depth->mm);
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  Eigen::Map<Eigen::Vector3d> by_centre(jacobians[0]);
  by_centre = -root_weight * weighted_.plane.normal;
  return true;
}

ScaleCost::ScaleCost(const KnownShape& shape, const MappingCurve& curve, MappingAlong along)
    : reading_(read_scale(shape, curve, curve.values().data(), along)), values_(curve.values()) {
  set_num_residuals(1);
  mutable_parameter_block_sizes()->push_back(curve.family().numbers());
}

bool ScaleCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  const double root_weight = kRootWeightOfKnown / reading_.sd;
  const Eigen::Map<const Eigen::VectorXd> values(parameters[0], values_.size());
  residuals[0] = root_weight *
                 (reading_.scale - 1 + reading_.by_values.dot(Eigen::VectorXd(values - values_)));
  if (!std::isfinite(residuals[0])) return false;
  if (jacobians != nullptr && jacobians[0] != nullptr)
    Eigen::Map<Eigen::VectorXd>(jacobians[0], values_.size()) = root_weight * reading_.by_values;
  return true;
}

PriorCost::PriorCost(int numbers, int index, double mean, double sd)
    : index_(index), mean_(mean), sd_(sd) {
  set_num_residuals(1);
  mutable_parameter_block_sizes()->push_back(numbers);
}

bool PriorCost::Evaluate(double const* const* parameters, double* residuals,
                         double** jacobians) const {
  residuals[0] = kRootWeightOfKnown * (parameters[0][index_] - mean_) / sd_;
  if (jacobians == nullptr || jacobians[0] == nullptr) return true;
  std::fill_n(jacobians[0], parameter_block_sizes()[0], 0.0);
  jacobians[0][index_] = kRootWeightOfKnown / sd_;
  return true;
}

double outline_angle_rad(const Eigen::Vector3d& direction, const Eigen::Vector3d& centre_mm,
                         double radius_mm, Eigen::Vector3d* by_centre) {
  const double distance = centre_mm.norm();
  if (!(distance > radius_mm)) return std::numeric_limits<double>::quiet_NaN();
  if (by_centre != nullptr) {
    // Moving the centre away from the ray widens the angle between them by 1 / |c|. Moving it back
    // along its own direction narrows the ball.
    const Eigen::Vector3d axis = centre_mm / distance;
    const Eigen::Vector3d aside = axis.cross(direction.cross(axis));  // of the ray
    const double cone = std::sqrt((distance - radius_mm) * (distance + radius_mm));
    *by_centre = axis * (radius_mm / (distance * cone));
    if (const double length = aside.norm(); length > 0.0) *by_centre -= aside / (length * distance);
  }
  return angle_between(direction, centre_mm) - std::asin(radius_mm / distance);
}

}  // namespace alltact
