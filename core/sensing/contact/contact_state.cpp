#include "core/sensing/contact/contact_state.h"

#include <algorithm>
#include <cmath>

namespace alltact {

ContactState::Told ContactState::add(const Seen& seen) {
  if (seen.time_s && last_s_ && (*seen.time_s < *last_s_ || *seen.time_s - *last_s_ > kMostGap_s))
    forget();
  Told told;
  follow(seen, told);
  has_begun_ = true;
  last_s_ = seen.time_s;
  if (!is_touched_) {
    places_.clear();
    return told;
  }
  told.is_touched = true;
  if (seen.time_s && began_s_) told.held_s = *seen.time_s - *began_s_;
  look_for_slip(seen, told);
  return told;
}

void ContactState::follow(const Seen& seen, Told& told) {
  const auto held_for = [&](bool holds, std::optional<double>& since, double duration_s) {
    if (!holds) {
      since.reset();
      return false;
    }
    if (!seen.time_s || !has_begun_) return true;
    if (!since) since = seen.time_s;
    return *seen.time_s - *since >= duration_s;
  };
  if (is_touched_) {
    if (held_for(seen.strength < kRelease, weak_s_, kRelease_s)) is_touched_ = false;
  } else if (held_for(seen.strength >= 1, strong_s_, kOnset_s)) {
    is_touched_ = told.is_new = true;
    began_s_ = strong_s_ ? strong_s_ : seen.time_s;
  }
  if (is_touched_) strong_s_.reset();
  if (!is_touched_) weak_s_.reset();
}

void ContactState::look_for_slip(const Seen& seen, Told& told) {
  if (!seen.time_s || !seen.place_mm) {
    places_.clear();
    return;
  }
  const Place now{*seen.time_s,
                  *seen.place_mm - Eigen::Vector2d(seen.skin_along_mm, 0),
                  seen.place_covariance_mm2};
  while (!places_.empty() && now.time_s - places_.front().time_s > kWindow_s) places_.pop_front();
  told.is_slipping = false;
  told.slip_mm = Eigen::Vector2d::Zero();
  // Against the one in the window that is furthest from here.
  for (const Place& before : places_) {
    const Eigen::Vector2d way = now.on_skin_mm - before.on_skin_mm;
    const double length = way.norm();
    if (!(length > told.slip_mm->norm())) continue;
    told.slip_mm = way;
    const Eigen::Vector2d unit = way / length;
    const double sd =
        std::sqrt(std::max(0.0, unit.dot((now.covariance_mm2 + before.covariance_mm2) * unit)));
    told.is_slipping = length > std::max(kSlipSds * sd, kLeastSlip_mm);
  }
  places_.push_back(now);
}

}  // namespace alltact
