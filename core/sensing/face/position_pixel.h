// Inverse projection of the face: from a position on it to its pixel.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

/// The pixel whose FaceShape::position_mm is `position_mm`, in valid columns. nullopt: no valid
/// column shows that length.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_position(const FaceShape& shape,
                                                               const Eigen::Vector2d& position_mm);

}  // namespace alltact
