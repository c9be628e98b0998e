#include "core/sensing/contact/face_contact.h"

#include <algorithm>
#include <cmath>

namespace alltact {
namespace {

constexpr double kContactDarkening = 0.12;  // of x: about a tenth of a layer
constexpr double kContactFraction =
    0.001;  // of the face: less than a ball of 4 mm pressed in 0.2 mm

}  // namespace

FaceContact face_contact(const std::vector<ContactRegion>& regions) {
  const bool has_contact = std::any_of(regions.begin(), regions.end(), [](const ContactRegion& r) {
    return r.deepest_mm > kContactDepth_mm;
  });
  return has_contact ? FaceContact::kInContact : FaceContact::kFree;
}

FaceContact face_contact(const Difference& difference) {
  std::size_t measured = 0, dark = 0;
  for (int v = 0; v < difference.x.rows; ++v) {
    const float* x = difference.x.ptr<float>(v);
    for (int u = 0; u < difference.x.cols; ++u) {
      measured += std::isfinite(x[u]) ? 1U : 0U;
      dark += x[u] > static_cast<float>(kContactDarkening) ? 1U : 0U;
    }
  }
  if (measured == 0) return FaceContact::kUnknown;
  return static_cast<double>(dark) > kContactFraction * static_cast<double>(measured)
             ? FaceContact::kInContact
             : FaceContact::kFree;
}

}  // namespace alltact
