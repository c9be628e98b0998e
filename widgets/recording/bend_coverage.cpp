#include "widgets/recording/bend_coverage.h"

#include <cmath>

namespace alltact {
namespace {

constexpr double kShown = 1.5;  // times what is needed: where the picture ends

int cell(double part) {
  const double at = (part + kShown) / (2 * kShown) * BendPicture::kCells;
  return std::clamp(static_cast<int>(std::floor(at)), 0, BendPicture::kCells - 1);
}

struct Sum {
  double u = 0, v = 0;
  int count = 0;
  [[nodiscard]] double mean_u() const { return u / count; }
  [[nodiscard]] double mean_v() const { return v / count; }
};

void reach(double& reached, double part) {
  reached = std::max(reached, part);
}

}  // namespace

std::optional<BendPose> bend_pose(const Markers& markers, const Markers& rest, bool base_at_low_u) {
  if (markers.size() != rest.size() || markers.empty()) return std::nullopt;
  std::array<Sum, 2> rows;
  std::size_t seen = 0;
  for (std::size_t m = 0; m < markers.size(); ++m) {
    Sum& row = rows[2 * m < markers.size() ? 0 : 1];
    row.u += markers[m].u - rest[m].u;
    row.v += markers[m].v - rest[m].v;
    ++row.count;
    seen += markers[m].seen ? 1U : 0U;
  }
  if (2 * seen < markers.size() || rows[0].count == 0 || rows[1].count == 0) return std::nullopt;
  const double towards_tip = base_at_low_u ? 1 : -1;
  BendPose pose;
  pose.bend_px = 0.5 * towards_tip * (rows[0].mean_u() + rows[1].mean_u());
  pose.sway_px = 0.5 * (rows[0].mean_v() + rows[1].mean_v());
  pose.twist_px = 0.5 * towards_tip * (rows[0].mean_u() - rows[1].mean_u());
  return pose;
}

BendNeed BendNeed::for_width(int width_px) {
  return {0.006 * width_px, 0.006 * width_px, 0.003 * width_px};
}

std::vector<BendDirection> BendPicture::missing() const {
  std::vector<BendDirection> missing;
  for (std::size_t d = 0; d < reached.size(); ++d)
    if (reached[d] < 1) missing.push_back(static_cast<BendDirection>(d));
  return missing;
}

void BendCoverage::begin(const BendNeed& need, std::optional<Markers> rest) {
  picture_ = {};
  picture_.need = need;
  rest_ = std::move(rest);
}

void BendCoverage::add(const Markers& markers, bool base_at_low_u) {
  if (!rest_) rest_ = markers;
  picture_.now = bend_pose(markers, *rest_, base_at_low_u);
  if (!picture_.now) return;
  const BendPose& pose = *picture_.now;
  const double bend = pose.bend_px / picture_.need.bend_px,
               sway = pose.sway_px / picture_.need.sway_px,
               twist = pose.twist_px / picture_.need.twist_px;
  const auto at = [&](BendDirection direction) -> double& {
    return picture_.reached[static_cast<std::size_t>(direction)];
  };
  reach(at(BendDirection::kAway), bend);
  reach(at(BendDirection::kTowards), -bend);
  reach(at(BendDirection::kDown), sway);
  reach(at(BendDirection::kUp), -sway);
  reach(at(BendDirection::kTwistRight), twist);
  reach(at(BendDirection::kTwistLeft), -twist);
  ++picture_.visits[static_cast<std::size_t>(cell(sway) * BendPicture::kCells + cell(bend))];
  ++picture_.poses;
}

}  // namespace alltact
