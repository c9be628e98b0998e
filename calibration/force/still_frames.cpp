#include "calibration/force/still_frames.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kMinStillPx = 0.3, kMaxStillPx = 1.5, kStillNoise = 4;
constexpr double kAroundEnter_s = 0.15, kNearestFrame_s = 0.5;

/// Root mean square distance of the markers seen in both; nullopt: none.
std::optional<double> distance_px(const Markers& one, const Markers& two) {
  if (one.size() != two.size()) return std::nullopt;
  double squares = 0, count = 0;
  for (std::size_t m = 0; m < one.size(); ++m)
    if (one[m].seen && two[m].seen) {
      squares += std::pow(one[m].u - two[m].u, 2) + std::pow(one[m].v - two[m].v, 2);
      count += 1;
    }
  return count > 0 ? std::optional(std::sqrt(squares / count)) : std::nullopt;
}

/// Root mean square distance of two neighbouring frames of a finger at rest. The median is one of
/// frames at rest as long as half of them are.
double noise_px(const std::vector<MarkerFrame>& frames) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < frames.size(); ++i)
    if (const auto step = distance_px(frames[i - 1].markers, frames[i].markers))
      steps.push_back(*step);
  if (steps.empty()) return 0;
  std::nth_element(steps.begin(), steps.begin() + static_cast<long>(steps.size() / 2), steps.end());
  return steps[steps.size() / 2];
}

/// Means of the markers over frames [first, last).
Markers mean_layout(const std::vector<MarkerFrame>& frames, std::size_t first, std::size_t last) {
  Markers mean = frames[first].markers;
  for (std::size_t m = 0; m < mean.size(); ++m) {
    double u = 0, v = 0, count = 0;
    for (std::size_t i = first; i < last; ++i)
      if (frames[i].markers.size() == mean.size() && frames[i].markers[m].seen)
        u += frames[i].markers[m].u, v += frames[i].markers[m].v, count += 1;
    mean[m].seen = count > 0;
    if (count > 0) mean[m].u = u / count, mean[m].v = v / count;
  }
  return mean;
}

}  // namespace

std::vector<int> held_readings(const std::vector<MarkerFrame>& frames,
                               const ForceGauge& gauge,
                               const GaugeClock& clock) {
  std::vector<int> held(frames.size(), -1);
  const double still_px = std::clamp(kStillNoise * noise_px(frames), kMinStillPx, kMaxStillPx);
  const auto frame_at = [&](double time_s) {
    return static_cast<std::size_t>(
        std::lower_bound(frames.begin(),
                         frames.end(),
                         time_s,
                         [](const MarkerFrame& f, double t) { return *f.time_s < t; }) -
        frames.begin());
  };
  for (std::size_t r = 0; r < gauge.readings.size(); ++r) {
    const GaugeReading& reading = gauge.readings[r];
    if (!reading.holds || !reading.has_force) continue;
    const double enter_s = clock.frame_time_s(reading.time_s);
    const std::size_t begin = frame_at(enter_s - kAroundEnter_s);
    const std::size_t end = std::max(frame_at(enter_s + kAroundEnter_s), begin + 1);
    if (begin >= frames.size() || std::abs(*frames[begin].time_s - enter_s) > kNearestFrame_s)
      continue;
    const Markers then = mean_layout(frames, begin, std::min(end, frames.size()));
    const std::size_t first =
        r == 0 ? 0 : frame_at(clock.frame_time_s(gauge.readings[r - 1].time_s));
    const std::size_t last = r + 1 == gauge.readings.size()
                                 ? frames.size()
                                 : frame_at(clock.frame_time_s(gauge.readings[r + 1].time_s));
    const auto take = [&](std::size_t i) {
      const auto distance = distance_px(frames[i].markers, then);
      if (!distance || *distance > still_px || held[i] >= 0) return false;
      held[i] = static_cast<int>(r);
      return true;
    };
    for (std::size_t i = std::min(end, last); i-- > first;)
      if (!take(i)) break;
    for (std::size_t i = std::min(end, last); i < last; ++i)
      if (!take(i)) break;
  }
  return held;
}

}  // namespace alltact
