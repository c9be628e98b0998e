#include "widgets/pair/view_pairing.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace alltact {

std::optional<ViewPair> ViewPairing::add(std::size_t which,
                                         std::shared_ptr<const LiveView> view,
                                         std::optional<std::int64_t> time_ns) {
  auto &own = views_[which], &other = views_[1 - which];
  if (!own.empty() && time_ns && own.back().time_ns && *time_ns < *own.back().time_ns)
    forget();  // another source, or a restarted one
  Timed now{std::move(view), time_ns};
  measure_period(which, now);
  own.push_back(std::move(now));
  if (own.size() > kMaxViews) own.pop_front();
  if (!waiting_since_ns_) waiting_since_ns_ = time_ns;
  if (other.empty()) return std::nullopt;
  const auto pair_with = [&](const Timed& partner) {
    ViewPair pair;
    pair.views[which] = own.back().view;
    pair.views[1 - which] = partner.view;
    return pair;
  };
  if (!time_ns || !other.back().time_ns) return pair_with(other.back());

  const Timed* nearest = nullptr;
  const auto offset_ns = [&](const Timed& timed) { return std::abs(*timed.time_ns - *time_ns); };
  for (const Timed& timed : other)
    if (timed.time_ns && (nearest == nullptr || offset_ns(timed) < offset_ns(*nearest)))
      nearest = &timed;
  ViewPair pair = pair_with(*nearest);
  std::array<std::int64_t, 2> times_ns{};
  times_ns[which] = *time_ns;
  times_ns[1 - which] = *nearest->time_ns;
  pair.later_ms = 1e-6 * static_cast<double>(times_ns[1] - times_ns[0]);
  pair.is_in_time = static_cast<double>(offset_ns(*nearest)) <= tolerance_ns();
  if (!pair.is_in_time) {
    const bool is_waiting = static_cast<double>(*time_ns - *waiting_since_ns_) < 1e9 * kTimeout_s;
    return is_waiting ? std::nullopt : std::optional(pair);
  }
  if (shown_ns_ && (times_ns[0] < (*shown_ns_)[0] || times_ns[1] < (*shown_ns_)[1]))
    return std::nullopt;
  shown_ns_ = times_ns;
  waiting_since_ns_ = std::max(times_ns[0], times_ns[1]);
  return pair;
}

/// Divides by frame numbers, so that frames that were not measured are counted.
void ViewPairing::measure_period(std::size_t which, const Timed& now) {
  if (views_[which].empty()) return;
  const Timed& before = views_[which].back();
  const FramePtr &frame = now.view->result.frame, &last = before.view->result.frame;
  if (!frame || !last || !now.time_ns || !before.time_ns || frame->sequence <= last->sequence)
    return;
  const auto frames = static_cast<double>(frame->sequence - last->sequence);
  period_ms_[which] = 1e-6 * static_cast<double>(*now.time_ns - *before.time_ns) / frames;
}

double ViewPairing::tolerance_ns() const {
  return 0.5e6 * std::max(period_ms_[0].value_or(0.0), period_ms_[1].value_or(0.0));
}

std::optional<double> ViewPairing::period_ms(std::size_t which) const {
  return period_ms_[which];
}

}  // namespace alltact
