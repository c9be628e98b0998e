// A small mark on the view face that changes its light.
#pragma once

#include "core/simulation/effect.h"

#include <Eigen/Core>

namespace alltact {

/// All within `radius_mm` of the line between two points (s, y) of the face: along it from its
/// base, and across from its middle line. A disc where the points coincide.
struct FaceMark {
  Eigen::Vector2d from_mm, to_mm;
  double radius_mm;
};

/// light = light * (1 + (factor - 1) * part) + level * part, part the share of the pixel within the
/// mark. It is first order: from the distance to the mark's edge in pixels, from 1/2 outside to 1/2
/// inside.
class MarkRows final : public RadianceEffect::Rows {
 public:
  MarkRows(const FrameGeometry& geometry, const FaceMark& mark, double factor, double level)
      : mark_(mark), camera_(geometry.rays().camera()), factor_(factor), level_(level) {}
  void row(RowView& row) const override;

 private:
  FaceMark mark_;
  const Camera& camera_;
  double factor_, level_;
};

}  // namespace alltact
