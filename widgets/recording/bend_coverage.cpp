#include "widgets/recording/bend_coverage.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace alltact {
namespace {

int cell(double part) {
  constexpr double kShown = BendPicture::kShown;
  const double at = (part + kShown) / (2 * kShown) * BendPicture::kCells;
  return std::clamp(static_cast<int>(std::floor(at)), 0, BendPicture::kCells - 1);
}

}  // namespace

std::vector<BendDirection> BendPicture::missing() const {
  std::vector<BendDirection> missing;
  for (std::size_t d = 0; d < reached.size(); ++d)
    if (reached[d] < 1) missing.push_back(static_cast<BendDirection>(d));
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
  is_set_ = true;
  show_again();
  return true;
}

std::optional<RestPose> BendCoverage::set_rest_pose() const {
  if (!is_set_ || !pair_) return std::nullopt;
  return RestPose{*pair_, *rest_};
}

// The pose nearest to the median of all, each motion in parts of what is needed of it.
void BendCoverage::choose_rest() {
  std::array<std::vector<double>, 3> parts;
  for (const TipPlace& place : places_) {
    const Motion motion = motion_between(places_.front(), place);
    parts[0].push_back(motion.bend_mm / picture_.need.bend_mm);
    parts[1].push_back(motion.sway_mm / picture_.need.sway_mm);
    parts[2].push_back(motion.twist_deg / picture_.need.twist_deg);
  }
  std::array<double, 3> middle{};
  for (std::size_t k = 0; k < parts.size(); ++k) {
    std::vector<double> values = parts[k];
    middle[k] = upper_median(values);
  }
  std::size_t nearest = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const double off =
        std::hypot(parts[0][i] - middle[0], parts[1][i] - middle[1], parts[2][i] - middle[2]);
    if (off < least) least = off, nearest = i;
  }
  rest_ = places_[nearest];
  next_choice_ = places_.size() + std::max<std::size_t>(1, places_.size() / 4);
  show_again();
}

void BendCoverage::show_again() {
  const auto now = now_;
  const MotionNeed need = picture_.need;
  picture_ = {};
  picture_.need = need;
  for (const TipPlace& place : places_) show(place);
  if (now)
    picture_.now = motion_between(*rest_, *now);
  else
    picture_.now.reset();
}

void BendCoverage::show(const TipPlace& place) {
  const Motion motion = motion_between(*rest_, place);
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
