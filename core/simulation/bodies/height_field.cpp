#include "core/simulation/bodies/height_field.h"

#include <algorithm>
#include <cmath>

namespace alltact {

namespace {

constexpr double kMinUpright = 0.08;
constexpr int kHalvings = 44;
constexpr int kSupportSteps = 256;

class PosedHeightField final : public PosedBody {
 public:
  PosedHeightField(const HeightField& body, const Eigen::Isometry3d& camera_from_object)
      : body_(body),
        object_from_camera_(camera_from_object.inverse()),
        up_(object_from_camera_.linear().col(2)),
        finest_mm_(body.finest_mm()) {}

  // Searches along the line over (x, y), by the height above the object's lowest plane.
  double lowest_z_mm(double x_mm, double y_mm, double below_mm) const override {
    if (up_.z() < kMinUpright) return HeightField::kNothing_mm;
    const Eigen::Vector3d top = object_from_camera_ * Eigen::Vector3d(x_mm, y_mm, below_mm);
    const double highest = top.z();
    if (!(highest > 0)) return HeightField::kNothing_mm;
    const Eigen::Vector2d drift = up_.head<2>() / up_.z();
    // Positive inside the body.
    const auto inside = [&](double height) {
      const Eigen::Vector2d at = top.head<2>() + (height - highest) * drift;
      return height - body_.gap_mm(at.x(), at.y());
    };
    const auto z_at = [&](double height) { return below_mm + (height - highest) / up_.z(); };
    const double travel = highest * drift.norm();
    if (travel < 1e-9) {
      const double gap = body_.gap_mm(top.x(), top.y());
      return gap < highest ? z_at(gap) : HeightField::kNothing_mm;
    }
    if (inside(0) >= 0) return z_at(0);
    const int steps = static_cast<int>(travel / finest_mm_) + 1;
    double outside = 0;
    for (int i = 1; i <= steps; ++i) {
      double within = highest * i / steps;
      if (!(inside(within) > 0)) {
        outside = within;
        continue;
      }
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = 0.5 * (outside + within);
        (inside(middle) > 0 ? within : outside) = middle;
      }
      return z_at(within);
    }
    return HeightField::kNothing_mm;
  }

 private:
  const HeightField& body_;
  Eigen::Isometry3d object_from_camera_;
  Eigen::Vector3d up_;  // the camera's z in the object's frame
  double finest_mm_;
};

}  // namespace

std::unique_ptr<const PosedBody> HeightField::posed(
    const Eigen::Isometry3d& camera_from_object) const {
  return std::make_unique<PosedHeightField>(*this, camera_from_object);
}

double HeightField::min_along_mm(const Eigen::Vector3d& direction) const {
  if (direction.head<2>().norm() < 1e-12) return 0;
  const Eigen::Vector2d half = half_size_mm();
  double min_value = kNothing_mm;
  for (int i = 0; i <= kSupportSteps; ++i)
    for (int k = 0; k <= kSupportSteps; ++k) {
      const double x = half.x() * (2.0 * i / kSupportSteps - 1);
      const double y = half.y() * (2.0 * k / kSupportSteps - 1);
      const double gap = gap_mm(x, y);
      if (std::isfinite(gap))
        min_value = std::min(min_value, direction.dot(Eigen::Vector3d(x, y, gap)));
    }
  return std::isfinite(min_value) ? min_value : 0;
}

}  // namespace alltact
