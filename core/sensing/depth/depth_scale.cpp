#include "core/sensing/depth/depth_scale.h"

#include "core/numerics/dispatch.h"

namespace alltact {
namespace {

ALLTACT_WIDE void scale_row(const float* __restrict factor, int count, float* __restrict depth) {
  for (int i = 0; i < count; ++i) depth[i] *= factor[i];
}

/// factor + across t, t = (v - middle) per_px within -1 to 1.
ALLTACT_WIDE void scale_row_across(const float* __restrict factor,
                                   const float* __restrict across,
                                   const float* __restrict middle_v,
                                   const float* __restrict per_px,
                                   float v,
                                   int count,
                                   float* __restrict depth) {
  for (int i = 0; i < count; ++i) {
    const float t = (v - middle_v[i]) * per_px[i];
    const float above = t > -1.0F ? t : -1.0F;
    depth[i] *= factor[i] + across[i] * (above < 1.0F ? above : 1.0F);
  }
}

}  // namespace

DepthScale::DepthScale(const MappingParameters& mapping, const FaceShape& shape) {
  const FaceVariation& variation = mapping.variation;
  const bool is_projected = mapping.along == MappingAlong::kProjected;
  if (variation.is_none() && !is_projected) return;
  by_column_ = is_projected ? shape.along_z_per_normal()
                            : std::vector<float>(static_cast<std::size_t>(shape.width_px()), 1.0F);
  if (variation.is_none()) return;
  across_ = middle_v_ = across_per_px_ = std::vector<float>(by_column_.size(), 0.0F);
  for (int u = 0; u < shape.width_px(); ++u) {
    const auto i = static_cast<std::size_t>(u);
    const FaceColumn& column = shape.columns()[i];
    if (!column.valid) continue;
    const double along_z = static_cast<double>(by_column_[i]);
    const double middle_v = 0.5 * (column.upper_v + column.lower_v);
    // Splits f into a factor that is constant across the face and a slope across it.
    const double s = variation.within(shape.position_mm(u, middle_v)).x();
    by_column_[i] = static_cast<float>(along_z * (1.0 + variation.part.x() * s));
    across_[i] = static_cast<float>(along_z * variation.part.y());
    const double per_px = shape.position_mm(u, middle_v + 1.0).y() / variation.half_mm.y();
    across_per_px_[i] = static_cast<float>(per_px);
    middle_v_[i] =
        static_cast<float>(middle_v + variation.middle_mm.y() / (per_px * variation.half_mm.y()));
  }
}

void DepthScale::scale(int v, int first, int count, float* depth_mm) const {
  if (across_.empty())
    scale_row(by_column_.data() + first, count, depth_mm);
  else
    scale_row_across(by_column_.data() + first,
                     across_.data() + first,
                     middle_v_.data() + first,
                     across_per_px_.data() + first,
                     static_cast<float>(v),
                     count,
                     depth_mm);
}

}  // namespace alltact
