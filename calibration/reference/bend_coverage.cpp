#include "calibration/reference/bend_coverage.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

int cell(double part) {
  constexpr double kShown = BendState::kShown;
  const double at = (part + kShown) / (2 * kShown) * BendState::kCells;
  return std::clamp(static_cast<int>(std::floor(at)), 0, BendState::kCells - 1);
}

}  // namespace

bool BendState::is_required(BendDirection direction) const {
  constexpr double kHardly = 0.5;  // of what is needed
  if (direction != BendDirection::kTwistRight && direction != BendDirection::kTwistLeft)
    return true;
  const auto reached_in = [this](BendDirection one) {
    return reached[static_cast<std::size_t>(one)];
  };
  const double bent = std::min({reached_in(BendDirection::kAway),
                                reached_in(BendDirection::kTowards),
                                reached_in(BendDirection::kUp),
                                reached_in(BendDirection::kDown)});
  const double twisted =
      std::max(reached_in(BendDirection::kTwistRight), reached_in(BendDirection::kTwistLeft));
  return bent < 1 || twisted >= kHardly;
}

std::vector<BendDirection> BendState::missing() const {
  std::vector<BendDirection> missing;
  for (std::size_t d = 0; d < reached.size(); ++d)
    if (const auto direction = static_cast<BendDirection>(d);
        reached[d] < 1 && is_required(direction))
      missing.push_back(direction);
  return missing;
}

void BendCoverage::begin(const MotionNeed& need) {
  state_ = {};
  state_.need = need;
  poses_.clear();
  next_choice_ = 1;
  if (is_set_) return;
  pair_.reset();
  rest_.reset();
  middle_ = {};
}

void BendCoverage::add(const Markers& markers, const FaceShape& shape) {
  std::optional<TipPose> pose;
  if (pair_) {
    if (2 * *pair_ < markers.size()) pose = tip_pose(markers, *pair_, shape);
  } else {
    for (std::size_t pair = markers.size() / 2; !pose && pair-- > 0;) {
      pose = tip_pose(markers, pair, shape);
      if (pose) pair_ = pair;
    }
  }
  if (pose)
    add(*pose);
  else
    clear_pose();
}

void BendCoverage::add(const TipPose& pose) {
  now_ = pose;
  poses_.push_back(pose);
  if (!is_set_ && poses_.size() >= next_choice_)
    choose_rest();
  else
    accumulate(pose);
}

void BendCoverage::clear_pose() {
  now_.reset();
  state_.now.reset();
}

bool BendCoverage::set_rest() {
  if (!now_) return false;
  rest_ = now_;
  middle_ = {};
  is_set_ = true;
  rebuild();
  return true;
}

std::optional<RestPose> BendCoverage::set_rest_pose() const {
  if (!is_set_ || !pair_) return std::nullopt;
  return RestPose{*pair_, *rest_};
}

// The middle of each motion separately: a finger that bends and twists at once need never have been
// in the middle of both.
void BendCoverage::choose_rest() {
  rest_ = poses_.front();
  std::vector<double> bend_mm, sway_mm, twist_deg;
  for (const TipPose& pose : poses_) {
    const TipMotion motion = motion_between(*rest_, pose);
    bend_mm.push_back(motion.bend_mm);
    sway_mm.push_back(motion.sway_mm);
    twist_deg.push_back(motion.twist_deg);
  }
  middle_ = {upper_median(bend_mm), upper_median(sway_mm), upper_median(twist_deg)};
  next_choice_ = poses_.size() + std::max<std::size_t>(1, poses_.size() / 4);
  rebuild();
}

TipMotion BendCoverage::motion_of(const TipPose& pose) const {
  const TipMotion motion = motion_between(*rest_, pose);
  return {motion.bend_mm - middle_.bend_mm,
          motion.sway_mm - middle_.sway_mm,
          motion.twist_deg - middle_.twist_deg};
}

void BendCoverage::rebuild() {
  const auto now = now_;
  const MotionNeed need = state_.need;
  state_ = {};
  state_.need = need;
  for (const TipPose& pose : poses_) accumulate(pose);
  state_.now = now ? std::optional(motion_of(*now)) : std::nullopt;
}

void BendCoverage::accumulate(const TipPose& pose) {
  const TipMotion motion = motion_of(pose);
  state_.now = motion;
  const double bend = motion.bend_mm / state_.need.bend_mm,
               sway = motion.sway_mm / state_.need.sway_mm,
               twist = motion.twist_deg / state_.need.twist_deg;
  const auto reach = [&](BendDirection direction, double part) {
    double& reached = state_.reached[static_cast<std::size_t>(direction)];
    reached = std::max(reached, part);
  };
  reach(BendDirection::kAway, bend);
  reach(BendDirection::kTowards, -bend);
  reach(BendDirection::kDown, sway);
  reach(BendDirection::kUp, -sway);
  reach(BendDirection::kTwistRight, twist);
  reach(BendDirection::kTwistLeft, -twist);
  ++state_.visits[static_cast<std::size_t>(cell(sway) * BendState::kCells + cell(bend))];
  ++state_.poses;
}

}  // namespace alltact
