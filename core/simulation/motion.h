// How a simulated finger moves from frame to frame.
#pragma once

#include "core/result.h"
#include "core/simulation/varying.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace alltact {

/// A pure function of (seed, frame): any frame can be asked for at any time.
///   hold:   the same pose in every frame, `pose: {q1_mm: 3}`; what is not named is 0.
///   path:   each degree of freedom that is named follows its key frames (varying.h), so that a
///           finger bends for a while and then holds still; what is not named is 0.
///   poses:  `poses: [{q1_mm: 3}, ...]`, frame i takes pose i modulo their number.
///   random: every frame draws each degree of freedom evenly from its range, on its own.
///   wander: from rest (all 0) to one place of the ranges and on to the next in `frames_per_move`
///           frames each, starting and arriving softly; the places fill the ranges evenly (Halton
///           sequence, shifted by seed).
class Motion {
 public:
  /// The motion of a scene that names none: hold, everything 0.
  Motion() = default;
  static Motion read(YamlSection& section);

  [[nodiscard]] double value(const DegreeOfFreedom& dof, std::uint64_t seed, int frame) const;
  /// Error: a pose names something that nothing moves, or puts it outside its range.
  [[nodiscard]] Status fits(const std::vector<DegreeOfFreedom>& dofs) const;

 private:
  enum class Kind { kPath = 1, kPoses, kRandom, kWander };
  [[nodiscard]] Status fits(const std::vector<DegreeOfFreedom>& dofs,
                            const std::string& name,
                            double least,
                            double greatest) const;
  using Pose = std::map<std::string, double>;

  Kind kind_ = Kind::kPoses;
  std::vector<Pose> poses_{Pose{}};
  std::map<std::string, Varying> path_;
  double frames_per_move_ = 1;
  std::string where_;
};

}  // namespace alltact
