#include "core/sensing/contact/contact_state.h"

#include <algorithm>
#include <cmath>

namespace alltact {

ContactState::Estimate ContactState::add(const Observation& seen) {
  if (seen.time_s && last_s_ && (*seen.time_s < *last_s_ || *seen.time_s - *last_s_ > kMaxGap_s))
    forget();
  Estimate estimate;
  update_contact(seen, estimate);
  has_begun_ = true;
  last_s_ = seen.time_s;
  if (!has_contact_) {
    samples_.clear();
    return estimate;
  }
  estimate.has_contact = true;
  if (seen.time_s && began_s_) estimate.held_s = *seen.time_s - *began_s_;
  detect_slip(seen, estimate);
  return estimate;
}

void ContactState::update_contact(const Observation& seen, Estimate& estimate) {
  const auto held_for = [&](bool holds, std::optional<double>& since, double duration_s) {
    if (!holds) {
      since.reset();
      return false;
    }
    if (!seen.time_s || !has_begun_) return true;
    if (!since) since = seen.time_s;
    return *seen.time_s - *since >= duration_s;
  };
  if (has_contact_) {
    if (held_for(seen.strength < kRelease, weak_s_, kRelease_s)) has_contact_ = false;
  } else if (held_for(seen.strength >= 1, strong_s_, kOnset_s)) {
    has_contact_ = estimate.is_new = true;
    began_s_ = strong_s_ ? strong_s_ : seen.time_s;
  }
  if (has_contact_) strong_s_.reset();
  if (!has_contact_) weak_s_.reset();
}

void ContactState::detect_slip(const Observation& seen, Estimate& estimate) {
  if (!seen.time_s || !seen.position_mm) {
    samples_.clear();
    return;
  }
  const Sample now{*seen.time_s,
                   *seen.position_mm - Eigen::Vector2d(seen.skin_along_mm, 0),
                   seen.position_covariance_mm2};
  while (!samples_.empty() && now.time_s - samples_.front().time_s > kWindow_s)
    samples_.pop_front();
  estimate.is_slipping = false;
  estimate.slip_mm = Eigen::Vector2d::Zero();
  // Relative to the sample in the window that is furthest from here.
  for (const Sample& before : samples_) {
    const Eigen::Vector2d displacement = now.on_skin_mm - before.on_skin_mm;
    const double length = displacement.norm();
    if (!(length > estimate.slip_mm->norm())) continue;
    estimate.slip_mm = displacement;
    const Eigen::Vector2d unit = displacement / length;
    const double sd =
        std::sqrt(std::max(0.0, unit.dot((now.covariance_mm2 + before.covariance_mm2) * unit)));
    estimate.is_slipping = length > std::max(kSlipSds * sd, kMinSlip_mm);
  }
  samples_.push_back(now);
}

}  // namespace alltact
