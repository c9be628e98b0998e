#include "calibration/force/collect_force.h"

#include "calibration/force/gauge_clock.h"
#include "calibration/force/still_frames.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace alltact {
namespace {

/// Looks up the readings of a gauge by frame.
class GaugeLookup {
 public:
  /// `frames` in the order of the look-ups.
  GaugeLookup(const std::vector<MarkerFrame>& frames,
              const ForceGauge& gauge,
              const GaugeClock& clock)
      : gauge_(gauge), clock_(clock) {
    if (gauge.by_time) {
      held_ = held_readings(frames, gauge, clock);
      return;
    }
    for (const GaugeReading& reading : gauge.readings) by_name_[reading.frame] = &reading;
  }

  [[nodiscard]] std::optional<GaugeReading> operator()(const MarkerFrame& frame,
                                                       std::size_t at) const {
    if (gauge_.by_time)
      return held_[at] >= 0 ? gauge_.readings[static_cast<std::size_t>(held_[at])]
                            : between(clock_.gauge_time_s(*frame.time_s));
    const auto found = by_name_.find(frame.name);
    if (found == by_name_.end() || !found->second->has_force) return std::nullopt;
    return *found->second;
  }

 private:
  [[nodiscard]] std::optional<GaugeReading> between(double time_s) const {
    const auto after =
        std::lower_bound(gauge_.readings.begin(),
                         gauge_.readings.end(),
                         time_s,
                         [](const GaugeReading& r, double t) { return r.time_s < t; });
    if (after == gauge_.readings.end()) return std::nullopt;
    if (after->holds || !after->has_force) return std::nullopt;
    if (after->time_s == time_s) return *after;
    if (after == gauge_.readings.begin()) return std::nullopt;
    const GaugeReading &one = *(after - 1), &two = *after;
    const double gap_s = two.time_s - one.time_s;
    if (!one.has_force || one.holds || gap_s > kLongestGaugeGapS || one.block != two.block)
      return std::nullopt;
    const double part = (time_s - one.time_s) / gap_s;
    GaugeReading interpolated = part < 0.5 ? one : two;
    interpolated.force_N = (1 - part) * one.force_N + part * two.force_N;
    return interpolated;
  }

  const ForceGauge& gauge_;
  GaugeClock clock_;
  std::vector<int> held_;
  std::map<std::string, const GaugeReading*> by_name_;
};

void add_row(const MarkerFrame& frame,
             const GaugeReading& reading,
             const ForceGauge& gauge,
             Eigen::Index row,
             ForceTable& table) {
  for (Eigen::Index m = 0; m < table.marker_count; ++m) {
    const Marker& marker = frame.markers[static_cast<std::size_t>(m)];
    table.seen(row, m) = marker.seen ? 1 : 0;
    table.layouts(row, 2 * m) = marker.seen ? marker.u : 0;
    table.layouts(row, 2 * m + 1) = marker.seen ? marker.v : 0;
  }
  table.force_N.row(row) = reading.force_N.head(table.axes).transpose();
  // The position that the pipeline measures takes precedence over the one of the set-up.
  const auto& position = frame.position_mm ? frame.position_mm : reading.position_mm;
  if (position) table.position_mm.row(row) = position->transpose();
  if (gauge.has_block) table.block.push_back(reading.block);
  if (gauge.has_day) table.day.push_back(reading.day);
  if (gauge.has_indenter) table.indenter.push_back(reading.indenter);
  table.frame.push_back(frame.name);
  if (table.time_s.size() > 0) table.time_s[row] = *frame.time_s;
}

/// The rows of a press, from one moment without load to the next, form one block. Too few presses
/// give no blocks.
void name_presses(ForceTable& table) {
  constexpr double kUnloaded = 0.1;
  constexpr int kMinPresses = 5;
  const Eigen::VectorXd force_N = table.force_N.rowwise().norm();
  std::vector<double> sorted(force_N.begin(), force_N.end());
  std::sort(sorted.begin(), sorted.end());
  const double loaded_N = sorted.empty() ? 0 : sorted[sorted.size() * 95 / 100];
  int presses = 0;
  bool is_loaded = false;
  std::vector<std::string> names;
  for (const double force : force_N) {
    // Hysteresis: loaded from 2 kUnloaded on, so that noise around the bound is one press.
    if (!is_loaded && force > 2 * kUnloaded * loaded_N) is_loaded = true, ++presses;
    if (is_loaded && force < kUnloaded * loaded_N) is_loaded = false;
    names.push_back(fmt::format("press {}", presses));
  }
  if (presses >= kMinPresses) table.block = std::move(names);
}

double median_sd_N(const std::vector<std::pair<const MarkerFrame*, GaugeReading>>& rows) {
  std::vector<double> sds;
  for (const auto& [frame, reading] : rows)
    if (std::isfinite(reading.sd_N)) sds.push_back(reading.sd_N);
  if (sds.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::nth_element(sds.begin(), sds.begin() + static_cast<long>(sds.size() / 2), sds.end());
  return sds[sds.size() / 2];
}

std::vector<MarkerFrame> in_order(const std::vector<MarkerFrame>& frames) {
  std::vector<MarkerFrame> ordered = frames;
  std::stable_sort(ordered.begin(), ordered.end(), [](const MarkerFrame& a, const MarkerFrame& b) {
    return *a.time_s < *b.time_s;
  });
  return ordered;
}

}  // namespace

Result<CollectedForce> collect_force(const std::vector<MarkerFrame>& all,
                                     const ForceGauge& gauge,
                                     const CollectOptions& options) {
  const bool all_timed = std::all_of(
      all.begin(), all.end(), [](const MarkerFrame& frame) { return frame.time_s.has_value(); });
  if (gauge.by_time && !all_timed)
    return Error{en::say("the recording's frames have no times, the gauge has nothing but times"),
                 "",
                 en::say("a recording of alltact record, or a gauge file with a column 'frame'")};
  const std::vector<MarkerFrame> frames = all_timed ? in_order(all) : all;
  CollectedForce collected;
  collected.frames = frames.size();
  collected.clock = estimate_gauge_clock(frames, gauge, options, collected.remarks);
  const GaugeLookup lookup(frames, gauge, collected.clock);
  std::vector<std::pair<const MarkerFrame*, GaugeReading>> rows;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    const MarkerFrame& frame = frames[i];
    const bool any = std::any_of(
        frame.markers.begin(), frame.markers.end(), [](const Marker& m) { return m.seen; });
    auto reading = any ? lookup(frame, i) : std::nullopt;
    if (reading && frame.markers.size() == frames.front().markers.size())
      rows.emplace_back(&frame, std::move(*reading));
    else
      ++collected.left_out;
  }
  collected.reading_sd_N = median_sd_N(rows);
  ForceTable& table = collected.table;
  const auto count = static_cast<Eigen::Index>(rows.size());
  table.marker_count = frames.empty() ? 0 : static_cast<int>(frames.front().markers.size());
  table.axes = gauge.axes;
  table.layouts = Eigen::MatrixXd::Zero(count, 2 * table.marker_count);
  table.seen = Eigen::MatrixXd::Zero(count, table.marker_count);
  table.force_N = Eigen::MatrixXd::Zero(count, table.axes);
  table.position_mm = Eigen::MatrixXd::Constant(count, 2, std::numeric_limits<double>::quiet_NaN());
  if (all_timed) table.time_s = Eigen::VectorXd::Zero(count);
  for (Eigen::Index row = 0; row < count; ++row) {
    const auto& [frame, reading] = rows[static_cast<std::size_t>(row)];
    add_row(*frame, reading, gauge, row, table);
  }
  if (!table.position_mm.array().isFinite().any()) table.position_mm.resize(0, 0);
  if (gauge.by_time && !gauge.has_block) name_presses(table);
  // This table must meet the conditions of any table.
  auto checked = ForceTable::parse_part(table.to_csv(), "");
  if (!checked) {
    Error error = checked.error();
    return Error{
        error.what, en::say("{} of {} frames have a reading", count, frames.size()), error.advice};
  }
  table = std::move(*checked);
  return collected;
}

}  // namespace alltact
