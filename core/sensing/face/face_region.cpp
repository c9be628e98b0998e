#include "core/sensing/face/face_region.h"

#include <algorithm>

namespace alltact {

cv::Range columns_of(const FaceRegion& region, const FaceShape& shape) {
  if (region == FaceRegion{}) return cv::Range::all();
  int first = shape.width_px(), end = 0;
  for (int u = 0; u < shape.width_px(); ++u) {
    const double mm = shape.length_at(u);
    if (mm < region.from_mm || mm > region.to_mm) continue;
    first = std::min(first, u);
    end = u + 1;
  }
  return first < end ? cv::Range(first, end) : cv::Range(0, 0);
}

}  // namespace alltact
