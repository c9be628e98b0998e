// Signals for the shift between two clocks: the fast part of motion and of force.
#pragma once

#include "calibration/force/collect_force.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Rows at ascending times. Values of invalid rows are unknown.
struct TimedRows {
  std::vector<double> time_s;
  Eigen::MatrixXd rows;
  std::vector<bool> is_valid;
};

/// Each row less the mean of those within half a window on either side. Rows are invalid where the
/// window exceeds an end or contains a gap or an invalid row.
[[nodiscard]] TimedRows fast_part(const TimedRows& signal, double window_s);

/// At most three principal components of the frames' layouts, hidden markers at their mean.
[[nodiscard]] TimedRows motion_signal(const std::vector<MarkerFrame>& frames);
/// The readings but those that are held.
[[nodiscard]] TimedRows force_signal(const ForceGauge& gauge);

/// Sums of a least-squares fit of force by motion.
struct FitSums {
  double count = 0;
  Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();  ///< of (motion, 1)
  Eigen::Matrix<double, 4, 3> both = Eigen::Matrix<double, 4, 3>::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  ///< of the force

  FitSums& operator+=(const FitSums& other);
  FitSums& operator-=(const FitSums& other);
  /// Sum of squares of the force about its mean.
  [[nodiscard]] double total() const;
  /// Fraction of it that motion explains; 0 where there is none or too few rows.
  [[nodiscard]] double r2() const;
};

/// The force at gauge time clock.gauge_time_s(t) + shift_s against the motion at t, for rows
/// [first, last) of the motion.
[[nodiscard]] FitSums fit_sums(const TimedRows& motion,
                               const TimedRows& force,
                               const GaugeClock& clock,
                               double shift_s,
                               std::size_t first,
                               std::size_t last,
                               std::size_t step = 1);

}  // namespace alltact
