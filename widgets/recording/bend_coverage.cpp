#include "widgets/recording/bend_coverage.h"

#include <cmath>

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
  rest_.reset();
}

void BendCoverage::add(const Markers& markers, const FaceShape& shape) {
  for (std::size_t pair = markers.size() / 2; !rest_ && pair-- > 0;) {
    rest_ = tip_place(markers, pair, shape);
    pair_ = pair;
  }
  const auto now = rest_ && 2 * pair_ < markers.size() ? tip_place(markers, pair_, shape)
                                                       : std::optional<TipPlace>();
  if (now)
    add(motion_between(*rest_, *now));
  else
    add_nothing();
}

void BendCoverage::add(const Motion& motion) {
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
