#include "core/sensing/contact/face_touch.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kTouchedDarker = 0.12;  // of x: about a tenth of a layer
constexpr double kTouchedShare = 0.001;  // of the face: a ball of 4 mm pressed in 0.2 mm is more

}  // namespace

FaceTouch face_touch(const std::vector<ContactRegion>& regions) {
  const bool is_touched = std::any_of(regions.begin(), regions.end(), [](const ContactRegion& r) {
    return r.deepest_mm > kTouchedDepth_mm;
  });
  return is_touched ? FaceTouch::kTouched : FaceTouch::kFree;
}

FaceTouch face_touch(const Difference& difference) {
  std::size_t measured = 0, dark = 0;
  for (int v = 0; v < difference.x.rows; ++v) {
    const float* x = difference.x.ptr<float>(v);
    for (int u = 0; u < difference.x.cols; ++u) {
      measured += std::isfinite(x[u]) ? 1U : 0U;
      dark += x[u] > static_cast<float>(kTouchedDarker) ? 1U : 0U;
    }
  }
  if (measured == 0) return FaceTouch::kUnknown;
  return static_cast<double>(dark) > kTouchedShare * static_cast<double>(measured)
             ? FaceTouch::kTouched
             : FaceTouch::kFree;
}

}  // namespace alltact
