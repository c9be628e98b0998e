#include "widgets/touch/touch_history.h"

#include <algorithm>
#include <cmath>

namespace alltact {

void TouchHistory::add(const FrameResult& result, double time_s) {
  if (now_s_ && time_s < *now_s_) forget();
  const bool is_after_gap = now_s_ && time_s > *now_s_ + kMaxGap_s;
  now_s_ = time_s;
  add_force(result.force, is_after_gap);
  add_contact(result.contact, is_after_gap);
  while (!forces_.empty() && forces_.front().time_s < time_s - kLength_s) forces_.pop_front();
  while (!slips_.empty() && slips_.front().to_s < time_s - kLength_s) slips_.pop_front();
  while (!contacts_.empty() && contacts_.front().to_s < time_s - kLength_s) contacts_.pop_front();
}

void TouchHistory::add_force(const std::optional<Force>& force, bool is_after_gap) {
  if (is_after_gap && !forces_.empty()) forces_.push_back({*now_s_, std::nullopt});
  const auto slot = [](double time_s) { return std::floor(time_s / kSlot_s); };
  const bool is_same_slot = !forces_.empty() && slot(forces_.back().time_s) == slot(*now_s_);
  if (is_same_slot && forces_.back().force && force)
    forces_.back() = {*now_s_, force};
  else if (!is_same_slot || force)  // a frame without a force does not replace one in the same slot
    forces_.push_back({*now_s_, force});
}

void TouchHistory::add_contact(const std::optional<FingerContact>& contact, bool is_after_gap) {
  const bool was_on = !contacts_.empty() && !contacts_.back().has_ended;
  // Between the frames one contact may have ended and the next begun.
  const bool is_another =
      contact && was_on &&
      (is_after_gap || contact->is_new ||
       (contact->held_s && *now_s_ - *contact->held_s > contacts_.back().to_s + kSlot_s));
  if (was_on && (!contact || is_another)) contacts_.back().has_ended = true;
  if (!contact) return;
  if (!was_on || is_another) {
    const double held_s = is_after_gap ? 0.0 : contact->held_s.value_or(0.0);
    contacts_.push_back({*now_s_ - std::min(held_s, kLength_s), *now_s_, contact->face});
  }
  Contact& now = contacts_.back();
  now.to_s = *now_s_;
  now.face = contact->face;
  if (contact->is_slipping.value_or(false)) add_slip();
}

void TouchHistory::add_slip() {
  if (slips_.empty() || *now_s_ - slips_.back().to_s > kSlipMerge_s) slips_.push_back({*now_s_, 0});
  slips_.back().to_s = *now_s_;
}

bool TouchHistory::has_slipped(const Contact& contact) const {
  return std::any_of(slips_.begin(), slips_.end(), [&](const Slip& slip) {
    return slip.from_s >= contact.from_s && slip.from_s <= contact.to_s;
  });
}

bool TouchHistory::has_forces() const {
  return std::any_of(forces_.begin(), forces_.end(), [](const auto& reading) {
    return reading.force.has_value();
  });
}

std::optional<ForceZero> present_zero(const TouchHistory& history) {
  if (!history.now_s()) return std::nullopt;
  ForceZero zero;
  int count = 0;
  for (auto reading = history.forces().rbegin(); reading != history.forces().rend(); ++reading) {
    if (reading->time_s < *history.now_s() - kZeroSpan_s) break;
    if (!reading->force) continue;
    const Force& force = *reading->force;
    if (!force.in_range) return std::nullopt;
    ++count;
    zero.force_N += force.force_N;
    zero.sd_N += force.sd_N;
    zero.half_90_N += force.half_90_N;
    zero.half_95_N += force.half_95_N;
  }
  if (count == 0) return std::nullopt;
  for (Eigen::Vector3d* sum : {&zero.force_N, &zero.sd_N, &zero.half_90_N, &zero.half_95_N})
    *sum /= count;
  zero.has_contact = !history.contacts().empty() && !history.contacts().back().has_ended;
  return zero;
}

Force zeroed(Force force, const std::optional<ForceZero>& zero) {
  if (!zero) return force;
  const auto both = [](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return Eigen::Vector3d((a.array().square() + b.array().square()).sqrt());
  };
  force.force_N -= zero->force_N;
  force.sd_N = both(force.sd_N, zero->sd_N);
  force.half_90_N = both(force.half_90_N, zero->half_90_N);
  force.half_95_N = both(force.half_95_N, zero->half_95_N);
  return force;
}

}  // namespace alltact
