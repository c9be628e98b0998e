#include "calibration/force/clock_signals.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Dense>

namespace alltact {
namespace {

constexpr Eigen::Index kMaxMotions = 3;
constexpr double kMinFitRows = 12;

Eigen::MatrixXd layouts_of(const std::vector<MarkerFrame>& frames) {
  const auto count = static_cast<Eigen::Index>(frames.size());
  const auto columns = static_cast<Eigen::Index>(2 * frames.front().markers.size());
  Eigen::MatrixXd layouts = Eigen::MatrixXd::Zero(count, columns);
  Eigen::MatrixXd seen = layouts;
  for (Eigen::Index row = 0; row < count; ++row) {
    const Markers& markers = frames[static_cast<std::size_t>(row)].markers;
    if (static_cast<Eigen::Index>(2 * markers.size()) != columns) continue;
    for (Eigen::Index m = 0; m < columns / 2; ++m) {
      const Marker& marker = markers[static_cast<std::size_t>(m)];
      if (!marker.seen) continue;
      layouts.row(row).segment<2>(2 * m) << marker.u, marker.v;
      seen.row(row).segment<2>(2 * m).setOnes();
    }
  }
  const Eigen::RowVectorXd mean =
      layouts.colwise().sum().cwiseQuotient(seen.colwise().sum().cwiseMax(1.0));
  return (layouts.rowwise() - mean).cwiseProduct(seen);
}

}  // namespace

TimedRows motion_signal(const std::vector<MarkerFrame>& frames) {
  TimedRows motion;
  for (const MarkerFrame& frame : frames) motion.time_s.push_back(*frame.time_s);
  motion.is_valid.assign(frames.size(), true);
  const Eigen::MatrixXd layouts = layouts_of(frames);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(layouts.transpose() * layouts);
  const Eigen::Index k = std::min(kMaxMotions, layouts.cols());
  motion.rows = layouts * solver.eigenvectors().rightCols(k);
  return motion;
}

TimedRows force_signal(const ForceGauge& gauge) {
  TimedRows force;
  std::vector<Eigen::Vector3d> rows;
  for (const GaugeReading& reading : gauge.readings) {
    if (reading.holds) continue;
    force.time_s.push_back(reading.time_s);
    force.is_valid.push_back(reading.has_force);
    rows.push_back(reading.force_N);
  }
  force.rows.resize(static_cast<Eigen::Index>(rows.size()), 3);
  for (Eigen::Index row = 0; row < force.rows.rows(); ++row)
    force.rows.row(row) = rows[static_cast<std::size_t>(row)].transpose();
  return force;
}

TimedRows fast_part(const TimedRows& signal, double window_s) {
  TimedRows fast = signal;
  const std::size_t count = signal.time_s.size();
  const double half_s = 0.5 * window_s;
  Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(signal.rows.cols());
  std::size_t first = 0, last = 0;  // rows of the window: [first, last)
  int bad = 0;                      // of these invalid, or after a gap
  const auto is_bad = [&](std::size_t i) {
    return !signal.is_valid[i] ||
           (i > 0 && signal.time_s[i] - signal.time_s[i - 1] > kLongestGaugeGapS);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const double now_s = signal.time_s[i];
    for (; last < count && signal.time_s[last] <= now_s + half_s; ++last) {
      sum += signal.rows.row(static_cast<Eigen::Index>(last));
      bad += is_bad(last) ? 1 : 0;
    }
    for (; signal.time_s[first] < now_s - half_s; ++first) {
      sum -= signal.rows.row(static_cast<Eigen::Index>(first));
      bad -= is_bad(first) ? 1 : 0;
    }
    fast.rows.row(static_cast<Eigen::Index>(i)) -= sum / static_cast<double>(last - first);
    fast.is_valid[i] = bad == 0 && signal.time_s.front() <= now_s - half_s &&
                       signal.time_s.back() >= now_s + half_s;
  }
  return fast;
}

FitSums& FitSums::operator+=(const FitSums& other) {
  count += other.count, motion += other.motion, both += other.both, squares += other.squares;
  return *this;
}
FitSums& FitSums::operator-=(const FitSums& other) {
  count -= other.count, motion -= other.motion, both -= other.both, squares -= other.squares;
  return *this;
}

double FitSums::total() const {
  if (count < 1) return 0;
  return (squares - both.row(3).transpose().cwiseAbs2() / count).sum();
}

double FitSums::r2() const {
  const double all = total();
  if (count < kMinFitRows || !(all > 1e-12)) return 0;
  // Regularisation by a little of each channel's own size stabilises channels without motion.
  Eigen::Matrix4d normal = motion;
  normal.diagonal().head<3>().array() += 1e-9 * motion.diagonal().head<3>().maxCoeff() + 1e-12;
  const Eigen::Matrix<double, 4, 3> weights = normal.ldlt().solve(both);
  const double left = (squares - weights.cwiseProduct(both).colwise().sum().transpose()).sum();
  return std::clamp(1 - left / all, 0.0, 1.0);
}

FitSums fit_sums(const TimedRows& motion,
                 const TimedRows& force,
                 const GaugeClock& clock,
                 double shift_s,
                 std::size_t first,
                 std::size_t last,
                 std::size_t step) {
  FitSums sums;
  std::size_t after = 0;
  for (std::size_t i = first; i < last; i += step) {
    if (!motion.is_valid[i]) continue;
    const double time_s = clock.gauge_time_s(motion.time_s[i]) + shift_s;
    if (after == 0)
      after = static_cast<std::size_t>(
          std::lower_bound(force.time_s.begin(), force.time_s.end(), time_s) -
          force.time_s.begin());
    while (after < force.time_s.size() && force.time_s[after] < time_s) ++after;
    if (after == 0) continue;
    if (after == force.time_s.size()) break;
    const double before_s = force.time_s[after - 1], gap_s = force.time_s[after] - before_s;
    if (!force.is_valid[after - 1] || !force.is_valid[after] || gap_s > kLongestGaugeGapS) continue;
    const double part = (time_s - before_s) / gap_s;
    const auto row = static_cast<Eigen::Index>(after);
    const Eigen::Vector3d interpolated_N =
        ((1 - part) * force.rows.row(row - 1) + part * force.rows.row(row)).transpose();
    Eigen::Vector4d moved(0, 0, 0, 1);
    moved.head(motion.rows.cols()) = motion.rows.row(static_cast<Eigen::Index>(i)).transpose();
    sums.count += 1;
    sums.motion += moved * moved.transpose();
    sums.both += moved * interpolated_N.transpose();
    sums.squares += interpolated_N.cwiseAbs2();
  }
  return sums;
}

}  // namespace alltact
