// A section of the face's length that depth is limited to.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <limits>

#include <opencv2/core.hpp>

namespace alltact {

/// In mm along the face from its base (FaceShape::length_at). Default: the full face.
struct FaceRegion {
  double from_mm = 0;
  double to_mm = std::numeric_limits<double>::infinity();

  bool operator==(const FaceRegion&) const = default;
};

/// Columns of the image that show the section; an empty range where none does. Range::all() for the
/// full face.
[[nodiscard]] cv::Range columns_of(const FaceRegion& region, const FaceShape& shape);

}  // namespace alltact
