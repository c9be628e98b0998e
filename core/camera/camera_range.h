// Plausibility of a camera, beyond the limits of the mathematics.
#pragma once

#include "core/camera/camera.h"

namespace alltact {

/// Check for files and typed values; Camera::create() checks the limits of the mathematics. Valid
/// are
///   a focal length of 0.05 to 10 times the image's longer side: 6 to 168 degrees of view,
///   fx and fy within a factor of 2: pixels are nearly square,
///   mm_per_px that makes the image 0.1 mm to 10 m wide.
/// Errors as of Camera::create(), which is called first; `where` is the key ("camera.fx").
[[nodiscard]] Status check_camera_range(const CameraParameters& parameters);

/// Possible but implausible values of a finger's camera: a focal length outside 0.2 to 4 times the
/// longer side (14 to 136 degrees of view), a principal point outside the middle three fifths of
/// the image. Each with its key.
[[nodiscard]] std::vector<Error> implausible_camera(const CameraParameters& parameters);

}  // namespace alltact
