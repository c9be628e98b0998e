// Is this a camera that somebody could have, rather than one that can be calculated with?
#pragma once

#include "core/camera/camera.h"

namespace alltact {

/// For files and what people type; Camera::create() looks at what the mathematics needs. Wants
///   a focal length of 0.05 to 10 times the picture's longer side: 6 to 168 degrees of view,
///   fx and fy within a factor of 2: pixels are nearly square,
///   mm_per_px that makes the picture 0.1 mm to 10 m wide.
/// Errors as of Camera::create(), which is asked first; `where` is the key ("camera.fx").
[[nodiscard]] Status check_camera_range(const CameraParameters& parameters);

/// What is possible and unusual of a camera in a finger: a focal length outside 0.2 to 4 times the
/// longer side (14 to 136 degrees of view), a principal point outside the middle three fifths of
/// the picture. Each with its key.
[[nodiscard]] std::vector<Error> implausible_camera(const CameraParameters& parameters);

}  // namespace alltact
