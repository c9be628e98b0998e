#include "calibration/presses/press_taker.h"

#include <algorithm>
#include <utility>

namespace alltact {

std::optional<PressTaker::Taken> PressTaker::request(double time_s) {
  if (is_enough()) return take(alike_);
  if (state_ != State::kWaits) {
    requested_s_ = time_s;
    contact_.begin();
  }
  state_ = State::kWaits;
  return std::nullopt;
}

std::optional<PressTaker::Taken> PressTaker::see(const FramePtr& frame,
                                                 const std::optional<DarkPatch>& contact,
                                                 double time_s) {
  if (!frame || frame == newest_) return std::nullopt;
  const bool goes_on =
      newest_ && frame->origin == newest_->origin && frame->sequence > newest_->sequence;
  if (!goes_on) held_.clear();  // another source, or the same from its beginning
  held_.add(frame);
  newest_ = frame;
  const auto before = std::exchange(alike_, held_.alike());
  if (state_ != State::kWaits) return std::nullopt;
  if (is_enough()) return take(alike_);
  const bool has_ended = alike_.size() < before.size();
  if (has_ended && before.size() >= kFewest) return take(before);
  if (contact_.add(contact, time_s)) return take(alike_);
  if (time_s - requested_s_ >= kTimeout_s) state_ = State::kRefused;
  return std::nullopt;
}

std::optional<PressTaker::Taken> PressTaker::end() {
  if (state_ != State::kWaits || alike_.empty()) return std::nullopt;
  return take(alike_);
}

void PressTaker::forget() {
  *this = PressTaker();
}

double PressTaker::held_part() const {
  // The first frame always equals itself.
  const double burst = alike_.size() < 2 ? 0.0 : static_cast<double>(alike_.size()) / kBurst;
  return std::min(1.0, burst);
}

bool PressTaker::is_enough() const {
  if (alike_.size() < kFewest) return false;
  const auto span_ns = alike_.back()->time_ns - alike_.front()->time_ns;
  return alike_.size() >= kBurst || 1e-9 * static_cast<double>(span_ns) >= kHeld_s;
}

PressTaker::Taken PressTaker::take(const std::vector<FramePtr>& frames) {
  state_ = State::kIdle;
  return {mean_frame(frames), frames.size()};
}

}  // namespace alltact
