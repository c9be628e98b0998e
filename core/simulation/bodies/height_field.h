// A body described by its underside.
#pragma once

#include "core/simulation/bodies/body.h"

#include <limits>

namespace alltact {

/// All points above the underside. Its lowest points lie at z = 0.
class HeightField : public Body {
 public:
  static constexpr double kNothing_mm = std::numeric_limits<double>::infinity();

  /// Height of the underside over (x, y), 0 or more; kNothing_mm where there is none.
  [[nodiscard]] virtual double gap_mm(double x_mm, double y_mm) const = 0;
  /// Detail thinner than this may be missed when it is viewed at a slant.
  [[nodiscard]] virtual double finest_mm() const { return 0.02; }

  [[nodiscard]] std::unique_ptr<const PosedBody> posed(
      const Eigen::Isometry3d& camera_from_object) const final;
  /// For a tilted body on a grid of 256 steps a side; exact for an upright one.
  [[nodiscard]] double min_along_mm(const Eigen::Vector3d& direction) const final;
};

}  // namespace alltact
