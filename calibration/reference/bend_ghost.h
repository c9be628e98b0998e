// Target outline of a finger that moves a little further: a guide for the hand during the recording
// of a reference.
#pragma once

#include "calibration/reference/bend_coverage.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

/// Both edges of the face from base to tip, px of the oriented image.
struct BentOutline {
  std::vector<Eigen::Vector2d> upper, lower;
};

/// The face moved by `motion` at its tip, as a cantilever beam: displacement (s / L)^2 of the
/// motion at s of the length L. nullopt: no face is visible.
[[nodiscard]] std::optional<BentOutline> bent_outline(const FaceShape& shape,
                                                      const TipMotion& motion);

/// Motion from the current pose to slightly beyond what is needed in a direction; zero where no
/// pose is known.
[[nodiscard]] TipMotion motion_left(const BendState& image, BendDirection direction);

}  // namespace alltact
