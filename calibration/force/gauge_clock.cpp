#include "calibration/force/collect_force.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Dense>

namespace alltact {
namespace {

/// Rows at ascending times. Values of invalid rows are unknown.
struct TimedRows {
  std::vector<double> time_s;
  Eigen::MatrixXd rows;
  std::vector<bool> is_valid;
};

/// Sums of a least-squares fit of force by motion.
struct FitSums {
  double count = 0;
  Eigen::Matrix4d motion = Eigen::Matrix4d::Zero();  ///< of (motion, 1)
  Eigen::Matrix<double, 4, 3> both = Eigen::Matrix<double, 4, 3>::Zero();
  Eigen::Vector3d squares = Eigen::Vector3d::Zero();  ///< of the force

  FitSums& operator+=(const FitSums& other);
  /// Sum of squares of the force about its mean.
  [[nodiscard]] double total() const;
  /// Fraction of it that motion explains; 0 where there is none or too few rows.
  [[nodiscard]] double r2() const;
};

/// The force at gauge time clock.gauge_time_s(t) + shift_s against the motion at t, for rows
/// [first, last) of the motion.
[[nodiscard]] FitSums fit_sums(const TimedRows& motion, const TimedRows& force,
                               const GaugeClock& clock, double shift_s, std::size_t first,
                               std::size_t last, std::size_t step = 1);

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

/// At most three principal components of the frames' layouts, hidden markers at their mean.
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

/// The readings but those that are held.
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

/// Each row less the mean of those within half a window on either side. Rows are invalid where the
/// window exceeds an end or contains a gap or an invalid row.
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

FitSums fit_sums(const TimedRows& motion, const TimedRows& force, const GaugeClock& clock,
                 double shift_s, std::size_t first, std::size_t last, std::size_t step) {
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

constexpr double kFineStep_s = 0.01, kCoarseStep_s = 0.05;
constexpr double kMinClockR2 = 0.3, kMaxClockSd_s = 0.05;
/// Lead in R2 over the next best shift, and depth of the valley that separates two shifts.
constexpr double kUnlikeR2 = 0.02, kValleyR2 = 0.06;
/// Fraction of the force that must be fast; less is rounding.
constexpr double kMinFastPart = 1e-2;
constexpr double kDriftWindow_s = 30, kDriftSearch_s = 0.3, kMaxDrift = 2e-3;
constexpr std::size_t kCoarseRows = 1500;

struct ShiftPeak {
  double shift_s = 0, r2 = 0;
  bool is_inside = false;  ///< not at an end of the searched range
};

/// The maximum of values at first_s + i step_s, refined by a parabola.
ShiftPeak peak_of(const std::vector<double>& values, double first_s, double step_s) {
  const auto best = std::max_element(values.begin(), values.end());
  const auto at = static_cast<std::size_t>(best - values.begin());
  ShiftPeak peak{first_s + step_s * static_cast<double>(at), *best, false};
  if (at == 0 || at + 1 == values.size()) return peak;
  peak.is_inside = true;
  const double bend = values[at - 1] - 2 * values[at] + values[at + 1];
  if (bend < 0)
    peak.shift_s += step_s * std::clamp(0.5 * (values[at - 1] - values[at + 1]) / bend, -0.5, 0.5);
  return peak;
}

/// Whether no other shift is as good: a periodic motion fits at every period.
bool is_unique(const std::vector<double>& values) {
  const auto best = std::max_element(values.begin(), values.end());
  const double max_r2 = *best;
  const auto goes_on = [&](auto from, auto to) {
    double valley = max_r2;
    for (; from != to; ++from) {
      valley = std::min(valley, *from);
      if (valley<max_r2 - kValleyR2&& * from> max_r2 - kUnlikeR2) return false;
    }
    return true;
  };
  return goes_on(best, values.end()) && goes_on(std::make_reverse_iterator(best), values.rend());
}

class ClockSearch {
 public:
  ClockSearch(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge)
      : motion_(fast_part(motion_signal(frames), kClockWindowS)),
        raw_(force_signal(gauge)),
        force_(fast_part(raw_, kClockWindowS)) {}

  [[nodiscard]] double frames_s() const { return motion_.time_s.back() - motion_.time_s.front(); }
  /// Whether there are enough rows of both, and the force has enough fast changes.
  [[nodiscard]] bool is_possible() const {
    if (raw_.time_s.size() < 20 || motion_.time_s.size() < 20) return false;
    double all = 0, fast = 0, count = 0;
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    for (Eigen::Index row = 0; row < raw_.rows.rows(); ++row)
      if (raw_.is_valid[static_cast<std::size_t>(row)])
        mean += raw_.rows.row(row).transpose(), count += 1;
    mean /= std::max(1.0, count);
    double fast_count = 0;
    for (Eigen::Index row = 0; row < raw_.rows.rows(); ++row) {
      const auto i = static_cast<std::size_t>(row);
      if (raw_.is_valid[i]) all += (raw_.rows.row(row).transpose() - mean).squaredNorm();
      if (force_.is_valid[i]) fast += force_.rows.row(row).squaredNorm(), fast_count += 1;
    }
    if (count < 2 || fast_count < 12 || !(all > 0)) return false;
    return std::sqrt(fast / fast_count) > kMinFastPart * std::sqrt(all / count);
  }

  /// Searches `range_s` on either side of the clock's shift and sets the shift. False:
  /// undetermined.
  [[nodiscard]] bool refine(double range_s, GaugeClock& clock) const {
    const int steps = static_cast<int>(std::ceil(range_s / kFineStep_s));
    const std::size_t rows = motion_.time_s.size();
    std::array<std::vector<FitSums>, kClockStretches> parts;
    std::vector<double> r2;
    for (int i = -steps; i <= steps; ++i) {
      FitSums total_sums;
      for (std::size_t k = 0; k < kClockStretches; ++k) {
        parts[k].push_back(fit_sums(motion_, force_, clock, i * kFineStep_s,
                                    k * rows / kClockStretches, (k + 1) * rows / kClockStretches));
        total_sums += parts[k].back();
      }
      r2.push_back(total_sums.r2());
    }
    const ShiftPeak peak = peak_of(r2, -steps * kFineStep_s, kFineStep_s);
    if (!peak.is_inside || peak.r2 < kMinClockR2 || !is_unique(r2)) return false;
    clock.sd_s = jackknife_sd_s(parts, peak, steps);
    if (!(clock.sd_s <= kMaxClockSd_s)) return false;
    clock.shift_s += peak.shift_s;
    clock.r2 = peak.r2;
    return true;
  }

  /// For unrelated clocks: searches every shift with an overlap of half of the shorter signal.
  [[nodiscard]] bool search_all(GaugeClock& clock) const {
    const double gauge_s = raw_.time_s.back() - raw_.time_s.front();
    const double shorter_s = std::min(gauge_s, frames_s());
    const double first_s = raw_.time_s.front() - motion_.time_s.back() + 0.5 * shorter_s;
    const double last_s = raw_.time_s.back() - motion_.time_s.front() - 0.5 * shorter_s;
    const std::size_t step = std::max<std::size_t>(1, motion_.time_s.size() / kCoarseRows);
    const std::size_t rows = motion_.time_s.size() / step;
    const double rows_a_s = static_cast<double>(rows) / frames_s();
    std::vector<double> r2;
    for (double shift_s = first_s; shift_s <= last_s; shift_s += kCoarseStep_s) {
      const FitSums sums =
          fit_sums(motion_, force_, clock, shift_s - clock.shift_s, 0, motion_.time_s.size(), step);
      const double min_count = 0.4 * std::max(0.0, shorter_s - kClockWindowS) * rows_a_s;
      r2.push_back(sums.count < min_count ? 0 : sums.r2());
    }
    if (r2.empty()) return false;
    const ShiftPeak peak = peak_of(r2, first_s, kCoarseStep_s);
    if (!is_unique(r2)) return false;
    if (peak.r2 < kMinClockR2) return false;
    clock.shift_s = peak.shift_s;
    return true;
  }

  /// Fits a line to the shifts of stretches over time. False: too few of them, or no line.
  [[nodiscard]] bool find_drift(GaugeClock& clock) const {
    const auto windows = static_cast<std::size_t>(std::min(20.0, frames_s() / kDriftWindow_s));
    if (windows < 4) return false;
    const std::size_t rows = motion_.time_s.size();
    std::vector<Eigen::Vector2d> points;  // time from first_s, shift
    for (std::size_t k = 0; k < windows; ++k) {
      const std::size_t first = k * rows / windows, last = (k + 1) * rows / windows;
      const int steps = static_cast<int>(kDriftSearch_s / kFineStep_s);
      std::vector<double> r2;
      for (int i = -steps; i <= steps; ++i)
        r2.push_back(fit_sums(motion_, force_, clock, i * kFineStep_s, first, last).r2());
      const ShiftPeak peak = peak_of(r2, -steps * kFineStep_s, kFineStep_s);
      if (!peak.is_inside || peak.r2 < kMinClockR2) continue;
      points.emplace_back(motion_.time_s[(first + last) / 2] - clock.first_s, peak.shift_s);
    }
    return fit_drift(points, clock);
  }

 private:
  [[nodiscard]] static double jackknife_sd_s(
      const std::array<std::vector<FitSums>, kClockStretches>& parts, const ShiftPeak& peak,
      int steps) {
    // Only around the peak of all stretches: one stretch less moves it little.
    const int middle = steps + static_cast<int>(std::lround(peak.shift_s / kFineStep_s));
    const int around = 15;
    const int first = std::max(0, middle - around), last = std::min(2 * steps, middle + around);
    std::vector<double> shifts;
    for (std::size_t without = 0; without < kClockStretches; ++without) {
      std::vector<double> r2;
      for (int i = first; i <= last; ++i) {
        FitSums sums;
        for (std::size_t k = 0; k < kClockStretches; ++k)
          if (k != without) sums += parts[k][static_cast<std::size_t>(i)];
        r2.push_back(sums.r2());
      }
      const ShiftPeak one = peak_of(r2, (first - steps) * kFineStep_s, kFineStep_s);
      if (!one.is_inside) return std::numeric_limits<double>::infinity();
      shifts.push_back(one.shift_s);
    }
    const double count = static_cast<double>(shifts.size());
    const double mean = std::accumulate(shifts.begin(), shifts.end(), 0.0) / count;
    double squares = 0;
    for (const double shift : shifts) squares += (shift - mean) * (shift - mean);
    return std::sqrt((count - 1) / count * squares);
  }

  [[nodiscard]] static bool fit_drift(const std::vector<Eigen::Vector2d>& points,
                                      GaugeClock& clock) {
    if (points.size() < 4) return false;
    const double count = static_cast<double>(points.size());
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Eigen::Vector2d& point : points) mean += point / count;
    double spread = 0, both = 0, left = 0;
    for (const Eigen::Vector2d& point : points) {
      spread += std::pow(point.x() - mean.x(), 2);
      both += (point.x() - mean.x()) * (point.y() - mean.y());
    }
    if (!(spread > 0)) return false;
    const double drift = both / spread;
    for (const Eigen::Vector2d& point : points)
      left += std::pow(point.y() - mean.y() - drift * (point.x() - mean.x()), 2);
    const double sd = std::sqrt(left / (count - 2) / spread);
    if (std::abs(drift) < 3 * sd || std::abs(drift) > kMaxDrift) return false;
    // The line retains its value at the middle of the points.
    clock.drift += drift;
    clock.shift_s += mean.y() - drift * mean.x();
    return true;
  }

  TimedRows motion_, raw_, force_;
};

bool overlap(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge) {
  return std::any_of(frames.begin(), frames.end(), [&](const MarkerFrame& frame) {
    return *frame.time_s >= gauge.readings.front().time_s &&
           *frame.time_s <= gauge.readings.back().time_s;
  });
}

void report_delay(const GaugeClock& clock, std::vector<Message>& remarks) {
  const double late_ms = 1e3 * clock.shift_s, sd_ms = 1e3 * clock.sd_s;
  remarks.push_back(late_ms >= 0 ? en::say("The gauge reports {:.0f} ms (sd {:.0f} ms) later than "
                                           "the images; this is corrected.",
                                           late_ms, sd_ms)
                                 : en::say("The gauge reports {:.0f} ms (sd {:.0f} ms) earlier "
                                           "than the images; this is corrected.",
                                           -late_ms, sd_ms));
}

GaugeClock same_clock(const ClockSearch* search, GaugeClock clock, std::vector<Message>& remarks) {
  GaugeClock found = clock;
  if (search != nullptr && search->refine(kLongestDelayS, found)) {
    found.source = GaugeClock::Source::kMotion;
    report_delay(found, remarks);
    return found;
  }
  remarks.push_back(
      en::say("The gauge's delay could not be estimated from these frames: nothing is corrected. "
              "Try: some quick taps while recording."));
  return clock;
}

GaugeClock other_clock(const ClockSearch* search, bool is_drift_given, double begun_s,
                       GaugeClock clock, std::vector<Message>& remarks) {
  GaugeClock found = clock;
  found.shift_s = begun_s;
  if (search != nullptr && search->search_all(found) && search->refine(0.2, found)) {
    if (!is_drift_given && search->find_drift(found)) (void)search->refine(0.2, found);
    found.source = GaugeClock::Source::kMotion;
    remarks.push_back(
        en::say("The gauge and the camera were on different clocks: {:.3f} s (sd {:.3f} s) apart "
                "by the markers' motion, drifting by {:.0f} ppm.",
                found.shift_s, found.sd_s, 1e6 * found.drift));
    return found;
  }
  remarks.push_back(en::say(
      "The gauge and the camera used different clocks: their starts are assumed to coincide."));
  clock.shift_s = begun_s;
  return clock;
}

}  // namespace

GaugeClock estimate_gauge_clock(const std::vector<MarkerFrame>& frames, const ForceGauge& gauge,
                                const CollectOptions& options, std::vector<Message>& remarks) {
  GaugeClock clock;
  if (!gauge.by_time || frames.empty()) return clock;
  clock.first_s = *frames.front().time_s;
  clock.drift = options.drift.value_or(0);
  if (options.shift_s) {
    clock.shift_s = *options.shift_s;
    clock.source = GaugeClock::Source::kGiven;
    return clock;
  }
  const bool is_typed = std::all_of(gauge.readings.begin(), gauge.readings.end(),
                                    [](const GaugeReading& r) { return r.holds || !r.has_force; });
  std::optional<ClockSearch> search;
  if (!is_typed) search.emplace(frames, gauge);
  const ClockSearch* use = search && search->is_possible() ? &*search : nullptr;
  if (gauge.is_on_frame_clock || overlap(frames, gauge))
    return is_typed ? clock : same_clock(use, clock, remarks);
  const double begun_s = gauge.readings.front().time_s - clock.first_s;
  return other_clock(use, options.drift.has_value(), begun_s, clock, remarks);
}

}  // namespace alltact
