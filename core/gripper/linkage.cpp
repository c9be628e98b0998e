#include "core/gripper/linkage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace alltact {
namespace {

constexpr double kMaxLength_mm = 1e4;
constexpr double kRounding = 8 * std::numeric_limits<double>::epsilon();

/// sqrt(a^2 - b^2), by factors so that nothing cancels; nullopt where b is larger.
std::optional<double> other_side(double a, double b) {
  const double square = (a - b) * (a + b);
  if (square < 0) return std::nullopt;
  return std::sqrt(square);
}

double to_one_turn(double rad) {
  constexpr double kTurn = 2 * std::numbers::pi;
  if (rad > std::numbers::pi) return rad - kTurn;
  return rad <= -std::numbers::pi ? rad + kTurn : rad;
}

/// The angle of a triangle between the sides `c` and `d`, opposite `r`, as half-angle sine and
/// cosine times a common factor. nullopt: the sides form no triangle.
std::optional<Eigen::Vector2d> half_angle(double c, double d, double r) {
  double across = ((r - d) + c) * (r + (d - c));
  double along = ((d - r) + c) * (d + (c + r));
  // In a dead point rounding must not open the loop.
  const double lower_limit = -kRounding * (c + d + r) * (c + d + r);
  if (across < lower_limit || along < lower_limit) return std::nullopt;
  across = std::max(0.0, across), along = std::max(0.0, along);
  if (!(across + along > 0)) return std::nullopt;
  return Eigen::Vector2d(std::sqrt(across), std::sqrt(along));
}

Error bad_length(const char* key, Message advice) {
  return {en::say("must be above 0 and at most {:g}", kMaxLength_mm), std::string(key), advice};
}

}  // namespace

Message to_message(DeadPointKind kind) {
  switch (kind) {
    case DeadPointKind::kStretched:
      return en::say("rod and crank are stretched into one line");
    case DeadPointKind::kFolded:
      return en::say("rod and crank are folded into one line");
    case DeadPointKind::kAcross:
      return en::say("the rod lies across the screw");
  }
  return {};
}

Result<Linkage> Linkage::create(const LinkageParameters& p, double lead_mm) {
  const auto is_point = [](const Eigen::Vector2d& at) {
    return at.allFinite() && at.cwiseAbs().maxCoeff() <= kMaxLength_mm;
  };
  if (!(std::abs(lead_mm) >= 1e-6 && std::abs(lead_mm) <= kMaxLength_mm))
    return Error{en::say("must be a travel in mm, above or below 0"),
                 std::string("lead_mm"),
                 en::say("how far the nut goes away from the palm in one turn, for example 2.0")};
  if (!is_point(p.pivot_mm))
    return Error{en::say("must be numbers from -{0:g} to {0:g}", kMaxLength_mm),
                 std::string("pivot_mm"),
                 en::say("x and z of the axis that the finger turns about, in mm")};
  if (!is_point(p.nut_mm))
    return Error{en::say("must be numbers from -{0:g} to {0:g}", kMaxLength_mm),
                 std::string("nut_mm"),
                 en::say("x and z of the rod's joint on the nut at motor position 0, in mm")};
  if (!(p.crank_mm > 0 && p.crank_mm <= kMaxLength_mm))
    return bad_length("crank_mm", en::say("the distance from the finger's axis to the rod, in mm"));
  if (!(p.rod_mm > 0 && p.rod_mm <= kMaxLength_mm))
    return bad_length("rod_mm", en::say("the distance between the rod's joints, in mm"));
  const double offset = std::abs(p.nut_mm.x() - p.pivot_mm.x());
  if (offset >= p.crank_mm + p.rod_mm)
    return Error{en::say("rod and crank never meet: together they reach {:g} mm, and the nut "
                         "passes the finger's axis at {:g} mm",
                         p.crank_mm + p.rod_mm,
                         offset),
                 std::string("rod_mm"),
                 en::say("measure pivot_mm, nut_mm, crank_mm and rod_mm again")};
  return Linkage(p, lead_mm);
}

double Linkage::turns_at_height(double above_pivot_mm) const {
  return (parameters_.pivot_mm.y() + above_pivot_mm - parameters_.nut_mm.y()) / lead_mm_;
}

Result<LinkageAngle> Linkage::angle_at(double motor_turns) const {
  const LinkageParameters& p = parameters_;
  if (!std::isfinite(motor_turns))
    return Error{en::say("the motor's position is no number"), "", en::say("a number of turns")};
  const double x = p.nut_mm.x() - p.pivot_mm.x();
  const double z = std::fma(lead_mm_, motor_turns, p.nut_mm.y() - p.pivot_mm.y());
  const double d = std::hypot(x, z), c = p.crank_mm, r = p.rod_mm;
  if (!(d > 0))
    return Error{en::say("at {:.6g} turns the rod's joint lies on the finger's axis, so that the "
                         "finger may stand anywhere",
                         motor_turns),
                 "",
                 en::say("another motor position")};
  const auto half = half_angle(c, d, r);
  if (!half) {
    const MotorReach reach = reach_around(motor_turns);
    return Error{en::say("rod and crank do not meet at {:.6g} turns: they do from {:.6g} ({}) to "
                         "{:.6g} ({})",
                         motor_turns,
                         reach.first.motor_turns,
                         to_message(reach.first.kind),
                         reach.last.motor_turns,
                         to_message(reach.last.kind)),
                 "",
                 en::say("a motor position between these")};
  }
  const double side = p.assembly == AssemblyMode::kAhead ? 1.0 : -1.0;
  const double angle = std::atan2(x, z) + side * 2.0 * std::atan2(half->x(), half->y());
  const double sine = 2.0 * half->x() * half->y() / half->squaredNorm();
  const double rod_z = z - c * std::cos(angle);
  // Rod and crank in line across the screw: the finger may continue in either direction.
  const double rate = sine == 0 && rod_z == 0 ? std::numeric_limits<double>::infinity()
                                              : -side * lead_mm_ * rod_z / (c * d * sine);
  return LinkageAngle{to_one_turn(angle), rate};
}

std::vector<MotorReach> Linkage::intervals() const {
  using Kind = DeadPointKind;
  const LinkageParameters& p = parameters_;
  const double x = std::abs(p.nut_mm.x() - p.pivot_mm.x());
  const double far = *other_side(p.crank_mm + p.rod_mm, x);
  const auto interval = [&](double low, Kind low_kind, double high, Kind high_kind) {
    MotorReach reach{{low_kind, turns_at_height(low)}, {high_kind, turns_at_height(high)}};
    if (lead_mm_ < 0) std::swap(reach.first, reach.last);
    return reach;
  };
  const auto near = other_side(std::abs(p.crank_mm - p.rod_mm), x);
  if (!near) return {interval(-far, Kind::kStretched, far, Kind::kStretched)};
  std::vector<MotorReach> intervals{interval(-far, Kind::kStretched, -*near, Kind::kFolded),
                                    interval(*near, Kind::kFolded, far, Kind::kStretched)};
  if (lead_mm_ < 0) std::swap(intervals[0], intervals[1]);
  return intervals;
}

MotorReach Linkage::reach_around(double motor_turns) const {
  const std::vector<MotorReach> all = intervals();
  const auto away = [&](const MotorReach& interval) {
    return std::max(
        {0.0, interval.first.motor_turns - motor_turns, motor_turns - interval.last.motor_turns});
  };
  return *std::min_element(
      all.begin(), all.end(), [&](const auto& a, const auto& b) { return away(a) < away(b); });
}

std::vector<DeadPoint> Linkage::dead_points() const {
  const LinkageParameters& p = parameters_;
  std::vector<DeadPoint> points;
  for (const MotorReach& interval : intervals())
    points.insert(points.end(), {interval.first, interval.last});
  const double x = p.nut_mm.x() - p.pivot_mm.x();
  const double side = p.assembly == AssemblyMode::kAhead ? 1.0 : -1.0;
  for (const double rod : {p.rod_mm, -p.rod_mm}) {
    // The pin is at the nut's height h above the pivot, at the lateral offset x + rod.
    const auto height = other_side(p.crank_mm, std::abs(x + rod));
    if (!height) continue;
    for (const double h : {*height, -*height}) {
      // On the side of the line to the nut that the assembly mode requires: sin(t - l) has the sign
      // of (x + rod) h - h x.
      if (side * rod * h > 0) points.push_back({DeadPointKind::kAcross, turns_at_height(h)});
    }
  }
  std::stable_sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return a.motor_turns < b.motor_turns;
  });
  return points;
}

}  // namespace alltact
