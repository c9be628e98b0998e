// Where a finger's outline would be seen if it were moved a little further: what a hand is to
// follow while a reference is recorded.
#pragma once

#include "calibration/reference/bend_coverage.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Both edges of the face from base to tip, px of the oriented picture.
struct BentOutline {
  std::vector<Eigen::Vector2d> upper, lower;
};

/// The face moved by `motion` at its tip, as a beam that is held at its base: by (s / L)^2 of it
/// where s of the length L lies behind. nullopt: no face is seen.
[[nodiscard]] std::optional<BentOutline> bent_outline(const FaceShape& shape,
                                                      const TipMotion& motion);

/// What is left from the pose now to a little beyond what is needed in a direction; nothing where
/// no pose is known.
[[nodiscard]] TipMotion motion_left(const BendPicture& picture, BendDirection direction);

}  // namespace alltact
