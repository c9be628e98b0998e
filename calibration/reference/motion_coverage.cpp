#include "calibration/reference/motion_coverage.h"

#include "core/numerics/median.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

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
  return TipPose{local->view_point_mm, local->normal,
                 std::atan2(upper.u - lower.u, lower.v - upper.v)};
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
  ask(en::say("twist it further to one side"), twist_.most, need_.twist_deg, degrees);
  ask(en::say("twist it further to the other side"), -twist_.least, need_.twist_deg, degrees);
  if (words.empty() && covered() < kEnough)
    words.push_back(
        en::say("bend it while its tip is pushed aside: {:.0f} % of the combinations were seen",
                100.0 * covered()));
  return words;
}

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
  const double bent =
      std::min({reached_in(BendDirection::kAway), reached_in(BendDirection::kTowards),
                reached_in(BendDirection::kUp), reached_in(BendDirection::kDown)});
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
  return {motion.bend_mm - middle_.bend_mm, motion.sway_mm - middle_.sway_mm,
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
  ++state_.visits[static_cast<std::size_t>(std::ptrdiff_t{cell(sway)} * BendState::kCells +
                                           cell(bend))];
  ++state_.poses;
}

namespace {

constexpr int kSections = 24;
constexpr double kBeyond = 1.1;  // times what is needed

/// A section of the face: the points of both edges, and the fraction of the length.
struct Section {
  Eigen::Vector3d upper, lower, normal;
  double part = 0;  ///< 0 at the base, 1 at the tip
};

std::vector<Section> sections_of(const FaceShape& shape) {
  std::vector<Section> sections;
  std::vector<int> valid;
  for (int u = 0; u < shape.width_px(); ++u)
    if (shape.columns()[static_cast<std::size_t>(u)].valid) valid.push_back(u);
  if (valid.size() < std::size_t{2} * kSections) return sections;
  if (!shape.base_at_low_u()) std::reverse(valid.begin(), valid.end());
  const double length = shape.length_at(valid.back());
  for (std::size_t i = 0; i <= kSections; ++i) {
    const int u = valid[i * (valid.size() - 1) / kSections];
    const auto rows = shape.rows(u, 0);
    const auto upper = shape.at(u, rows.first), lower = shape.at(u, rows.last);
    if (rows.first >= rows.last || !upper || !lower || !(length > 0)) continue;
    sections.push_back({upper->view_point_mm, lower->view_point_mm,
                        (upper->normal + lower->normal).normalized(), shape.length_at(u) / length});
  }
  return sections;
}

}  // namespace

std::optional<BentOutline> bent_outline(const FaceShape& shape, const TipMotion& motion) {
  const auto sections = sections_of(shape);
  if (sections.size() < 2) return std::nullopt;
  const Eigen::Vector3d by =
      motion.bend_mm * sections.back().normal + motion.sway_mm * Eigen::Vector3d::UnitY();
  BentOutline outline;
  for (const Section& section : sections) {
    const double weight = section.part * section.part;
    const Eigen::Vector3d middle = 0.5 * (section.upper + section.lower);
    const Eigen::AngleAxisd turn(weight * motion.twist_deg * M_PI / 180, Eigen::Vector3d::UnitZ());
    const auto seen = [&](const Eigen::Vector3d& point) {
      return shape.camera().project(middle + turn * (point - middle) + weight * by);
    };
    const auto upper = seen(section.upper), lower = seen(section.lower);
    if (!upper || !lower) continue;
    outline.upper.push_back(*upper);
    outline.lower.push_back(*lower);
  }
  return outline.upper.size() < 2 ? std::nullopt : std::optional(outline);
}

TipMotion motion_left(const BendState& image, BendDirection direction) {
  TipMotion left;
  if (!image.now) return left;
  const auto to = [](double now, double need, bool is_up) {
    return (is_up ? 1 : -1) * kBeyond * need - now;
  };
  switch (direction) {
    case BendDirection::kAway:
    case BendDirection::kTowards:
      left.bend_mm = to(image.now->bend_mm, image.need.bend_mm, direction == BendDirection::kAway);
      break;
    case BendDirection::kDown:
    case BendDirection::kUp:
      left.sway_mm = to(image.now->sway_mm, image.need.sway_mm, direction == BendDirection::kDown);
      break;
    case BendDirection::kTwistRight:
    case BendDirection::kTwistLeft:
      left.twist_deg =
          to(image.now->twist_deg, image.need.twist_deg, direction == BendDirection::kTwistRight);
      break;
  }
  return left;
}

}  // namespace alltact
