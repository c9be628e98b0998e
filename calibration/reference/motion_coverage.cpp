#include "calibration/reference/motion_coverage.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kReached = 0.9;  // fraction of the need that counts as reached
constexpr double kEnough = 0.8;   // of the cells

int cell_of(double value, double need) {
  const double part = (value + need) / (2.0 * need);
  return static_cast<int>(std::floor(part * MotionCoverage::kCells));
}

/// The corners of bend with sway, which no grasp reaches.
bool is_corner(int column, int row) {
  const auto off = [](int i) { return std::abs(2 * i + 1 - MotionCoverage::kCells); };
  return off(column) + off(row) > MotionCoverage::kCells + 2;
}

void widen(MotionCoverage::Reach& reach, double value) {
  reach.least = std::min(reach.least, value);
  reach.most = std::max(reach.most, value);
}

}  // namespace

std::optional<TipPose> tip_pose(const Markers& markers, std::size_t pair, const FaceShape& shape) {
  const Marker& upper = markers[pair];
  const Marker& lower = markers[pair + markers.size() / 2];
  // The dots lie in front of the face; its middle is where the image shows it between them.
  const double u = 0.5 * (upper.u + lower.u);
  const auto column = std::lround(u);
  if (column < 0 || column >= shape.width_px()) return std::nullopt;
  const FaceColumn& face = shape.columns()[static_cast<std::size_t>(column)];
  const auto local = shape.at(u, 0.5 * (face.upper_v + face.lower_v));
  if (!local) return std::nullopt;
  return TipPose{
      local->view_point_mm, local->normal, std::atan2(upper.u - lower.u, lower.v - upper.v)};
}

TipMotion motion_between(const TipPose& rest, const TipPose& now) {
  const Eigen::Vector3d moved = now.middle_mm - rest.middle_mm;
  return {moved.dot(rest.normal), moved.y(), (now.turn_rad - rest.turn_rad) * 180.0 / M_PI};
}

void MotionCoverage::add(const TipMotion& motion) {
  widen(bend_, motion.bend_mm);
  widen(sway_, motion.sway_mm);
  widen(twist_, motion.twist_deg);
  const int column = cell_of(motion.bend_mm, need_.bend_mm);
  const int row = cell_of(motion.sway_mm, need_.sway_mm);
  if (column < 0 || row < 0 || column >= kCells || row >= kCells) return;
  ++cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)];
}

double MotionCoverage::covered() const {
  double all = 0, seen = 0;
  for (int row = 0; row < kCells; ++row)
    for (int column = 0; column < kCells; ++column) {
      if (is_corner(column, row)) continue;
      ++all;
      seen += cells_[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] > 0;
    }
  return seen / all;
}

std::vector<Message> MotionCoverage::missing() const {
  std::vector<Message> words;
  const Message mm = en::say("mm"), degrees = en::say("degrees");
  const auto ask = [&](const Message& what, double reached, double need, const Message& unit) {
    if (reached < kReached * need)
      words.push_back(
          en::at(what, en::say("{:.1f} of {:.1f} {} reached", std::max(0.0, reached), need, unit)));
  };
  ask(en::say("bend it further away from the camera"), bend_.most, need_.bend_mm, mm);
  ask(en::say("bend it further towards the camera"), -bend_.least, need_.bend_mm, mm);
  ask(en::say("push its tip further to one side"), sway_.most, need_.sway_mm, mm);
  ask(en::say("push its tip further to the other side"), -sway_.least, need_.sway_mm, mm);
  ask(en::say("twist it further one way"), twist_.most, need_.twist_deg, degrees);
  ask(en::say("twist it further the other way"), -twist_.least, need_.twist_deg, degrees);
  if (words.empty() && covered() < kEnough)
    words.push_back(
        en::say("bend it while its tip is pushed aside: {:.0f} % of the combinations were seen",
                100.0 * covered()));
  return words;
}

}  // namespace alltact
