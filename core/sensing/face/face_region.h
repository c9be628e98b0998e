// A part of the face's length, for what need not look at all of it.
#pragma once

#include "core/sensing/face/face_shape.h"

#include <limits>

#include <opencv2/core.hpp>

namespace alltact {

/// In mm along the face from its base (FaceShape::length_at). As it comes: all of it.
struct FaceRegion {
  double from_mm = 0;
  double to_mm = std::numeric_limits<double>::infinity();

  bool operator==(const FaceRegion&) const = default;
};

/// Columns of the picture that show it; an empty range where the face has none such. Range::all()
/// for all of the face.
[[nodiscard]] cv::Range columns_of(const FaceRegion& region, const FaceShape& shape);

}  // namespace alltact
