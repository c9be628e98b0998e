// The rod and the crank that convert a screw's travel into the rotation of a finger: an offset
// slider-crank whose slider is the screw's nut.
//
//      z ^        C  crank pin             N = (nut_x, nut_z + lead m)   on the nut, at motor m
//        |       / \ .                     C = P + c (sin t, cos t)      carried by the finger
//        |      /    \  rod r              |N - C| = r                   the loop equation
//        |   c / t     \ .
//        |    /          N  nut            t: the crank's angle, from +z towards +x
//        |   P  pivot    |  slides along z
//        +---------------|-------> x
//
// Everything lies in the gripper's plane of x (the fingers close along it) and z (along the screw,
// away from the palm); the pivot's axis is y.
//
// CLOSED FORM. With D = N - P of length d and direction l, the law of cosines in the triangle of c,
// r and d gives the angle at P by its half, which loses no digits where the triangle is flat
// (W. Kahan, Miscalculating area and angles of a needle-like triangle, 2014):
//   t = l +- f,   tan(f/2) = sqrt( ((r - d) + c) (r + (d - c)) / (((d - r) + c) (d + (c + r))) )
// The sign is the assembly mode: the same parts fit together in two configurations.
//
// DERIVATIVE. From the loop equation, with C' = dC/dt:  (N - C).C' dt = (N - C).z ds, and
// (N - C).C' = -+ c d sin(f):
//   dt/dm = lead (N - C)_z / (-+ c d sin(f))
//
// DEAD POINTS (J. J. Uicker, G. R. Pennock, J. E. Shigley, Theory of Machines and Mechanisms, on
// the slider-crank). Where rod and crank lie in one line, stretched (d = r + c) or folded
// (d = |r - c|), the loop closes no farther and dt/dm is infinite. Where the rod lies across the
// screw, dt/dm is 0: the finger stands still and reverses beyond.
#pragma once

#include "core/message.h"
#include "core/result.h"

#include <vector>

#include <Eigen/Core>

namespace alltact {

/// The side of the line from pivot to nut on which the crank's pin lies.
enum class AssemblyMode {
  kAhead = 1,  ///< t = l + f: from the line towards +x, in the sense of t
  kBehind,     ///< t = l - f
};

struct LinkageParameters {
  Eigen::Vector2d pivot_mm = {0, 0};  ///< x, z in the gripper
  Eigen::Vector2d nut_mm = {0, 0};    ///< x, z of the rod's joint on the nut at motor position 0
  double crank_mm = 0;                ///< pivot to pin, above 0
  double rod_mm = 0;                  ///< pin to nut, above 0
  AssemblyMode assembly = AssemblyMode::kAhead;
};

enum class DeadPointKind {
  kStretched = 1,  ///< rod and crank in one line, one behind the other; dt/dm infinite
  kFolded,         ///< in one line, one upon the other; dt/dm infinite
  kAcross,         ///< the rod lies across the screw; dt/dm is 0
};
[[nodiscard]] Message to_message(DeadPointKind kind);

struct DeadPoint {
  DeadPointKind kind;
  double motor_turns;
};

/// The interval of motor positions in which the loop closes, ends included.
struct MotorReach {
  DeadPoint first, last;
};

struct LinkageAngle {
  double rad = 0;           ///< t, in (-pi, pi]
  double rad_per_turn = 0;  ///< dt/dm; infinite in dead points that end the reach
};

/// A value. Motor positions are in turns of the screw. A motor with other units needs its own lead
/// (1 for mm of travel).
class Linkage {
 public:
  /// lead_mm: travel of the nut along +z in one turn, not 0. Errors (`where` is the key): a number
  /// that is not finite or beyond 10000 mm; a length not above 0; parts that never join, since the
  /// nut passes the pivot beyond the reach of crank and rod.
  static Result<Linkage> create(const LinkageParameters& parameters, double lead_mm);

  /// Error: the loop does not close there, or nut and pivot coincide so that the crank's angle is
  /// undefined. The message gives the valid interval.
  [[nodiscard]] Result<LinkageAngle> angle_at(double motor_turns) const;

  /// All of them, ascending: 2 to 6.
  [[nodiscard]] std::vector<DeadPoint> dead_points() const;

  /// The closing interval nearest to a motor position, or the one that contains it.
  [[nodiscard]] MotorReach reach_around(double motor_turns) const;

  [[nodiscard]] const LinkageParameters& parameters() const { return parameters_; }
  [[nodiscard]] double lead_mm() const { return lead_mm_; }

 private:
  Linkage(const LinkageParameters& parameters, double lead_mm)
      : parameters_(parameters), lead_mm_(lead_mm) {}
  [[nodiscard]] double turns_at_height(double above_pivot_mm) const;
  [[nodiscard]] std::vector<MotorReach> intervals() const;

  LinkageParameters parameters_;
  double lead_mm_;
};

}  // namespace alltact
