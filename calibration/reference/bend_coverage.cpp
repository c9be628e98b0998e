#include "calibration/reference/bend_coverage.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

int cell(double part) {
  constexpr double kShown = BendPicture::kShown;
  const double at = (part + kShown) / (2 * kShown) * BendPicture::kCells;
  return std::clamp(static_cast<int>(std::floor(at)), 0, BendPicture::kCells - 1);
}

}  // namespace

bool BendPicture::is_wanted(BendDirection direction) const {
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

std::vector<BendDirection> BendPicture::missing() const {
  std::vector<BendDirection> missing;
  for (std::size_t d = 0; d < reached.size(); ++d)
    if (const auto direction = static_cast<BendDirection>(d);
        reached[d] < 1 && is_wanted(direction))
      missing.push_back(direction);
  return missing;
}

void BendCoverage::begin(const MotionNeed& need) {
  picture_ = {};
  picture_.need = need;
  places_.clear();
  next_choice_ = 1;
  if (is_set_) return;
  pair_.reset();
  rest_.reset();
  middle_ = {};
}

void BendCoverage::add(const Markers& markers, const FaceShape& shape) {
  std::optional<TipPlace> place;
  if (pair_) {
    if (2 * *pair_ < markers.size()) place = tip_place(markers, *pair_, shape);
  } else {
    for (std::size_t pair = markers.size() / 2; !place && pair-- > 0;) {
      place = tip_place(markers, pair, shape);
      if (place) pair_ = pair;
    }
  }
  if (place)
    add(*place);
  else
    add_nothing();
}

void BendCoverage::add(const TipPlace& place) {
  now_ = place;
  places_.push_back(place);
  if (!is_set_ && places_.size() >= next_choice_)
    choose_rest();
  else
    show(place);
}

void BendCoverage::add_nothing() {
  now_.reset();
  picture_.now.reset();
}

bool BendCoverage::set_rest() {
  if (!now_) return false;
  rest_ = now_;
  middle_ = {};
  is_set_ = true;
  show_again();
  return true;
}

std::optional<RestPose> BendCoverage::set_rest_pose() const {
  if (!is_set_ || !pair_) return std::nullopt;
  return RestPose{*pair_, *rest_};
}

// Half-way through each motion on its own: a finger that bends and twists at once need never have
// been in the middle of both.
void BendCoverage::choose_rest() {
  rest_ = places_.front();
  std::vector<double> bend_mm, sway_mm, twist_deg;
  for (const TipPlace& place : places_) {
    const TipMotion motion = motion_between(*rest_, place);
    bend_mm.push_back(motion.bend_mm);
    sway_mm.push_back(motion.sway_mm);
    twist_deg.push_back(motion.twist_deg);
  }
  middle_ = {upper_median(bend_mm), upper_median(sway_mm), upper_median(twist_deg)};
  next_choice_ = places_.size() + std::max<std::size_t>(1, places_.size() / 4);
  show_again();
}

TipMotion BendCoverage::motion_of(const TipPlace& place) const {
  const TipMotion motion = motion_between(*rest_, place);
  return {motion.bend_mm - middle_.bend_mm,
          motion.sway_mm - middle_.sway_mm,
          motion.twist_deg - middle_.twist_deg};
}

void BendCoverage::show_again() {
  const auto now = now_;
  const MotionNeed need = picture_.need;
  picture_ = {};
  picture_.need = need;
  for (const TipPlace& place : places_) show(place);
  picture_.now = now ? std::optional(motion_of(*now)) : std::nullopt;
}

void BendCoverage::show(const TipPlace& place) {
  const TipMotion motion = motion_of(place);
  picture_.now = motion;
  const double bend = motion.bend_mm / picture_.need.bend_mm,
               sway = motion.sway_mm / picture_.need.sway_mm,
               twist = motion.twist_deg / picture_.need.twist_deg;
  const auto reach = [&](BendDirection direction, double part) {
    double& reached = picture_.reached[static_cast<std::size_t>(direction)];
    reached = std::max(reached, part);
  };
  reach(BendDirection::kAway, bend);
  reach(BendDirection::kTowards, -bend);
  reach(BendDirection::kDown, sway);
  reach(BendDirection::kUp, -sway);
  reach(BendDirection::kTwistRight, twist);
  reach(BendDirection::kTwistLeft, -twist);
  ++picture_.visits[static_cast<std::size_t>(cell(sway) * BendPicture::kCells + cell(bend))];
  ++picture_.poses;
}

}  // namespace alltact
