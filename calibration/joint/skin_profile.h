// Depth of the skin around a ball, and light that spreads from it, as functions of the distance
// from the contact's axis.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace alltact {

/// A function of the distance from an axis, in equal steps up to a reach.
class RadialProfile {
 public:
  static constexpr int kCount = 160;
  explicit RadialProfile(double reach_mm) : step_mm_(reach_mm / kCount), values_(kCount) {}
  [[nodiscard]] double radius_mm(int i) const { return (i + 0.5) * step_mm_; }
  double& operator[](int i) { return values_[static_cast<std::size_t>(i)]; }
  [[nodiscard]] double operator[](int i) const { return values_[static_cast<std::size_t>(i)]; }
  /// Linear between the steps; flat on the axis and beyond the reach.
  [[nodiscard]] double at(double r_mm) const;
  /// q of light_spread.h of which this function is e. Beyond the reach it decays as exp(-r /
  /// width).
  [[nodiscard]] RadialProfile skirt_lost(double width_mm) const;
  /// Its mean over K0(r sqrt(2) / sd): a blur by `sd_mm` in each direction.
  [[nodiscard]] RadialProfile blurred(double sd_mm) const;

 private:
  /// Solves q - squared_width(value) laplace q = value.
  template <class SquaredWidth>
  [[nodiscard]] RadialProfile diffused(double width_mm, const SquaredWidth& squared_width) const;

  double step_mm_;
  std::vector<double> values_;
};

/// What carries the skin outside a contact.
enum class Bed {
  kMembrane,   ///< a stretched skin on a thin layer: contact_model.h
  kHalfSpace,  ///< K. L. Johnson, Contact Mechanics, 3.42a, faded by the bond of the layer
};

/// How a skin leaves a ball. Silicones, layers and paints differ so much that no single form fits.
struct SkinForm {
  Bed bed = Bed::kMembrane;
  /// Membrane: lift-off length where sqrt(R depth) is one layer thickness.
  double lift_mm = 0.12;
  /// It grows with sqrt(R depth) to this power: 0 under tension, 1 where the skin's form does not
  /// depend on scale.
  double lift_power = 0;
  double fade_mm = 2.4;  ///< half space: length of its fading
  /// Incompressible material yields outward and rises around the ball: heights, as parts of the
  /// layer's thickness at a depth of one thickness, of swellings half, one and two thicknesses
  /// from the edge; negative where the skin returns slowly.
  std::array<double, 3> rise{};
  double rise_power = 1;  ///< they grow with the depth to this power
};

/// A ball pressed into the layer.
struct RoundContact {
  double radius_mm = 0;
  double curvature_per_mm = 0;  ///< of the face along it, positive where it bulges outward
  double layer_mm = 0;
  double depth_mm = 0;  ///< along the normal
};

/// Depth of the skin along the normal, mm; negative where it rises.
[[nodiscard]] RadialProfile skin_profile(const RoundContact& contact, const SkinForm& form,
                                         double reach_mm);

}  // namespace alltact
