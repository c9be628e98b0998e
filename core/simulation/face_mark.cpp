#include "core/simulation/face_mark.h"

namespace alltact {

void MarkRows::row(RowView& row) const {
  const FaceRow& face = row.face;
  const Eigen::Vector2d segment = mark_.to_mm - mark_.from_mm;
  const double length2 = segment.squaredNorm();
  const double s_low = std::min(mark_.from_mm.x(), mark_.to_mm.x()) - mark_.radius_mm - 1;
  const double s_high = std::max(mark_.from_mm.x(), mark_.to_mm.x()) + mark_.radius_mm + 1;
  for (int u = face.first; u < face.last; ++u) {
    if (face.s_mm[u] < s_low || face.s_mm[u] > s_high) continue;
    const Eigen::Vector2d at(face.s_mm[u], face.y_mm[u] - face.shift_mm[u]);
    const double along =
        length2 > 0 ? std::clamp((at - mark_.from_mm).dot(segment) / length2, 0.0, 1.0) : 0.0;
    const double inside = mark_.radius_mm - (at - mark_.from_mm - along * segment).norm();
    const double part = std::clamp(inside / camera_.mm_per_px_at(face.z_mm[u]) + 0.5, 0.0, 1.0);
    if (part == 0) continue;
    float& light = row.surfaces[0].light[u];
    light = static_cast<float>(light * (1 + (factor_ - 1) * part) + level_ * part);
  }
}

}  // namespace alltact
