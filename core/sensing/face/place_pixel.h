// Which pixel shows a place of the face.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <optional>

#include <Eigen/Core>

namespace alltact {

/// The pixel of which FaceShape::place_mm tells this place: its inverse, where the column that is
/// told is a valid one. nullopt: none lies so far along the face.
[[nodiscard]] std::optional<Eigen::Vector2d> pixel_of_place(const FaceShape& shape,
                                                            const Eigen::Vector2d& place_mm);

}  // namespace alltact
