// Positions and depths of the first six presses of an uncalibrated finger, so that a live view can
// show the next one.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>
#include <vector>

#include <Eigen/Core>

namespace alltact {

struct PressTarget {
  Eigen::Vector2d position_mm = Eigen::Vector2d::Zero();  ///< FaceShape::position_mm
  double depth_mm = 0;                                    ///< along the normal
};

/// Base, middle and tip, each twice: once on each side of the middle line, from two fifths to seven
/// tenths of the layer deep. Presses of different depths determine the mapping's lower end
/// (calibrate.h). Over the visible part of the face; empty where none is.
[[nodiscard]] std::vector<PressTarget> first_presses(const FaceShape& shape);

/// The first of `targets` without a press at `made_mm`. A press counts for the target nearest to
/// it; two presses at one position count once.
[[nodiscard]] std::optional<PressTarget> next_press(const std::vector<PressTarget>& targets,
                                                    const std::vector<Eigen::Vector2d>& made_mm);

/// The pixel of a position on the face; the nearest one where that is not in the image. nullopt: no
/// face is visible.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                               const Eigen::Vector2d& position_mm);

enum class PressProgress {
  kDeeper = 1,
  kEnough,   ///< from 0.85 times the target
  kTooDeep,  ///< beyond 1.4 times, or 0.8 of the layer, where silicone tears and mappings end
};
[[nodiscard]] PressProgress press_progress(double depth_mm, double target_mm, double layer_mm);

}  // namespace alltact
