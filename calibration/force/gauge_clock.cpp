#include "calibration/force/gauge_clock.h"

#include "calibration/force/clock_signals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace alltact {
namespace {

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
        parts[k].push_back(fit_sums(motion_,
                                    force_,
                                    clock,
                                    i * kFineStep_s,
                                    k * rows / kClockStretches,
                                    (k + 1) * rows / kClockStretches));
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
      const std::array<std::vector<FitSums>, kClockStretches>& parts,
      const ShiftPeak& peak,
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
  remarks.push_back(late_ms >= 0 ? en::say("The gauge tells {:.0f} ms (sd {:.0f} ms) after the "
                                           "pictures; that is taken out.",
                                           late_ms,
                                           sd_ms)
                                 : en::say("The gauge tells {:.0f} ms (sd {:.0f} ms) before the "
                                           "pictures; that is taken out.",
                                           -late_ms,
                                           sd_ms));
}

GaugeClock same_clock(const ClockSearch* search, GaugeClock clock, std::vector<Message>& remarks) {
  GaugeClock found = clock;
  if (search != nullptr && search->refine(kLongestDelayS, found)) {
    found.source = GaugeClock::Source::kMotion;
    report_delay(found, remarks);
    return found;
  }
  remarks.push_back(
      en::say("How late the gauge tells could not be told from these frames: nothing is taken out. "
              "Try: some quick taps while recording."));
  return clock;
}

GaugeClock other_clock(const ClockSearch* search,
                       bool is_drift_given,
                       double begun_s,
                       GaugeClock clock,
                       std::vector<Message>& remarks) {
  GaugeClock found = clock;
  found.shift_s = begun_s;
  if (search != nullptr && search->search_all(found) && search->refine(0.2, found)) {
    if (!is_drift_given && search->find_drift(found)) (void)search->refine(0.2, found);
    found.source = GaugeClock::Source::kMotion;
    remarks.push_back(
        en::say("The gauge and the camera were on different clocks: {:.3f} s (sd {:.3f} s) apart "
                "by the markers' motion, drifting by {:.0f} ppm.",
                found.shift_s,
                found.sd_s,
                1e6 * found.drift));
    return found;
  }
  remarks.push_back(
      en::say("The gauge and the camera were on different clocks: their beginnings are taken for "
              "one moment."));
  clock.shift_s = begun_s;
  return clock;
}

}  // namespace

GaugeClock estimate_gauge_clock(const std::vector<MarkerFrame>& frames,
                                const ForceGauge& gauge,
                                const CollectOptions& options,
                                std::vector<Message>& remarks) {
  GaugeClock clock;
  if (!gauge.by_time || frames.empty()) return clock;
  clock.first_s = *frames.front().time_s;
  clock.drift = options.drift.value_or(0);
  if (options.shift_s) {
    clock.shift_s = *options.shift_s;
    clock.source = GaugeClock::Source::kGiven;
    return clock;
  }
  const bool is_typed = std::all_of(gauge.readings.begin(),
                                    gauge.readings.end(),
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
