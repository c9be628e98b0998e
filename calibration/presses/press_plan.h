// Where to press a ball, and how deep: six presses for a finger that was never calibrated, told so
// that a live picture can show the next one.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct PressTarget {
  Eigen::Vector2d place_mm = Eigen::Vector2d::Zero();  ///< FaceShape::place_mm
  double depth_mm = 0;                                 ///< along the normal
};

/// Base, middle and tip, each twice: on one side of the middle line and on the other, from two
/// fifths to seven tenths of the layer deep, since presses of different depths hold the mapping's
/// lower end (calibrate.h). Over the part of the face that is seen; empty where none is.
[[nodiscard]] std::vector<PressTarget> first_presses(const FaceShape& shape);

/// The first of `targets` that no press at `made_mm` stands for. A press stands for the target
/// nearest to it; two presses at one place stand for one.
[[nodiscard]] std::optional<PressTarget> next_press(const std::vector<PressTarget>& targets,
                                                    const std::vector<Eigen::Vector2d>& made_mm);

/// The pixel that shows a place of the face; the nearest one that does where that is not in the
/// picture. nullopt: no face is seen.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_place(const FaceShape& shape,
                                                            const Eigen::Vector2d& place_mm);

enum class PressedSoFar {
  kDeeper = 1,
  kEnough,   ///< from 0.85 times the target on
  kTooDeep,  ///< beyond 1.4 times, or 0.8 of the layer, where silicone tears and mappings end
};
[[nodiscard]] PressedSoFar pressed_so_far(double depth_mm, double target_mm, double layer_mm);

}  // namespace alltact
