#include "core/sensing/contact/principal_axis.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr double kMaxLogWeight = 0.6931471805599453;  // ln 2, from end to end

struct Flat {
  Eigen::Vector2d mean;
  Eigen::Matrix2d covariance;
  double weight = 0;
};

/// Two passes about the mean, to avoid cancellation.
Flat moments_of(const std::vector<ContactColumn>& columns,
                const ContactPlane& plane,
                const std::vector<double>& certainty) {
  Flat flat{Eigen::Vector2d::Zero(), Eigen::Matrix2d::Zero()};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const double weight = certainty[i] * columns[i].volume_mm3;
    flat.weight += weight;
    flat.mean += weight * (plane.transpose() * columns[i].middle_mm);
  }
  if (!(flat.weight > 0)) return flat;
  flat.mean /= flat.weight;
  const Eigen::Vector2d upright = plane.row(2).transpose();  // projection of a column of volume
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const ContactColumn& column = columns[i];
    const Eigen::Vector2d off = plane.transpose() * column.middle_mm - flat.mean;
    flat.covariance += certainty[i] * column.volume_mm3 / flat.weight *
                       (off * off.transpose() +
                        column.height_mm * column.height_mm / 12.0 * upright * upright.transpose());
  }
  return flat;
}

/// The slope of log(1 / variance) over the contact, by least squares.
Eigen::Vector2d log_slope(const std::vector<ContactColumn>& columns,
                          const ContactPlane& plane,
                          const Flat& flat) {
  double mean_log = 0, weights = 0;
  for (const ContactColumn& column : columns)
    if (column.skin_sd_mm > 0) {
      mean_log -= 2.0 * column.volume_mm3 * std::log(column.skin_sd_mm);
      weights += column.volume_mm3;
    }
  if (!(weights > 0)) return Eigen::Vector2d::Zero();
  mean_log /= weights;
  Eigen::Matrix2d normal = Eigen::Matrix2d::Zero();
  Eigen::Vector2d right = Eigen::Vector2d::Zero();
  for (const ContactColumn& column : columns) {
    if (!(column.skin_sd_mm > 0)) continue;
    const Eigen::Vector2d off = plane.transpose() * column.middle_mm - flat.mean;
    normal += column.volume_mm3 * off * off.transpose();
    right += column.volume_mm3 * off * (-2.0 * std::log(column.skin_sd_mm) - mean_log);
  }
  if (!(normal.determinant() > 1e-9 * normal.trace() * normal.trace()))
    return Eigen::Vector2d::Zero();
  return normal.inverse() * right;
}

std::vector<double> certainty_of(const std::vector<ContactColumn>& columns,
                                 const ContactPlane& plane,
                                 const Flat& flat) {
  const Eigen::Vector2d slope = log_slope(columns, plane, flat);
  std::vector<double> logs;
  for (const ContactColumn& column : columns)
    logs.push_back(slope.dot(plane.transpose() * column.middle_mm - flat.mean));
  const auto [lowest, highest] = std::minmax_element(logs.begin(), logs.end());
  const double part = std::min(1.0, kMaxLogWeight / std::max(*highest - *lowest, kMaxLogWeight));
  for (double& value : logs) value = std::exp(part * value);
  return logs;
}

}  // namespace

std::optional<PrincipalAxis> principal_axis(const std::vector<ContactColumn>& columns,
                                            const ContactPlane& plane,
                                            double correlated_px2) {
  const Flat alike = moments_of(columns, plane, std::vector<double>(columns.size(), 1.0));
  if (!(alike.weight > 0)) return std::nullopt;
  const std::vector<double> certainty = certainty_of(columns, plane, alike);
  const Flat flat = moments_of(columns, plane, certainty);
  const double xx = flat.covariance(0, 0), xy = flat.covariance(0, 1), yy = flat.covariance(1, 1);
  const double difference = std::hypot(xx - yy, 2.0 * xy);
  if (!(difference > 0.0)) return std::nullopt;
  PrincipalAxis axis;
  axis.angle_rad = 0.5 * std::atan2(2.0 * xy, xx - yy);
  if (axis.angle_rad <= -M_PI / 2) axis.angle_rad += M_PI;
  axis.greater_mm2 = 0.5 * (xx + yy + difference);
  axis.smaller_mm2 = std::max(0.0, xx * yy - xy * xy) / axis.greater_mm2;
  const double c = std::cos(axis.angle_rad), s = std::sin(axis.angle_rad);
  double squares = 0;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    const Eigen::Vector2d off = plane.transpose() * columns[i].pressed_mm - flat.mean;
    const double x = c * off.x() + s * off.y(), y = c * off.y() - s * off.x();
    squares += columns[i].noise_mm6 * std::pow(certainty[i] * x * y, 2);
  }
  axis.sd_rad = std::sqrt(correlated_px2 * squares) / (flat.weight * difference);
  return axis;
}

}  // namespace alltact
