// The motion of a simulated finger from frame to frame.
#pragma once

#include "core/result.h"
#include "core/simulation/varying.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace alltact {

/// A pure function of (seed, frame): frames may be evaluated in any order.
///   hold:   the same pose in every frame, `pose: {q1_mm: 3}`; unnamed degrees of freedom are 0.
///   path:   each named degree of freedom follows its key frames (varying.h), so that a finger
///           bends for a while and then holds still; unnamed ones are 0.
///   poses:  `poses: [{q1_mm: 3}, ...]`, frame i takes pose i modulo their number.
///   random: every frame draws each degree of freedom evenly and independently from its range.
///   wander: from rest (all 0) from one point of the ranges to the next in `frames_per_move` frames
///           each, with soft starts and stops; the points fill the ranges evenly (Halton sequence,
///           shifted by seed).
class Motion {
 public:
  /// The default motion of a scene: hold, everything 0.
  Motion() = default;
  static Motion read(YamlSection& section);

  [[nodiscard]] double value(const DegreeOfFreedom& dof, std::uint64_t seed, int frame) const;
  /// Error: a pose names a degree of freedom that no effect moves, or exceeds its range.
  [[nodiscard]] Status validate(const std::vector<DegreeOfFreedom>& dofs) const;

 private:
  enum class Kind { kPath = 1, kPoses, kRandom, kWander };
  [[nodiscard]] Status validate(const std::vector<DegreeOfFreedom>& dofs,
                                const std::string& name,
                                double min_value,
                                double max_value) const;
  using Pose = std::map<std::string, double>;

  Kind kind_ = Kind::kPoses;
  std::vector<Pose> poses_{Pose{}};
  std::map<std::string, Varying> path_;
  double frames_per_move_ = 1;
  std::string where_;
};

}  // namespace alltact
