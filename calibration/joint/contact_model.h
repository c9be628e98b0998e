// Contact of a ball and the skin: how deep both lie over a sample, with the lift-off of the skin at
// the rim, and the position of a sample in the contact.
#pragma once

#include "calibration/joint/mapping_curve.h"
#include "calibration/presses/press.h"
#include "core/finger/mapping.h"

#include <Eigen/Core>

namespace alltact {

// Lift-off of the skin at the rim of a ball's contact.
//
// A skin on its layer is a stretched membrane on an elastic bed. It follows a rigid ball up to a
// contact radius a and leaves it there without a corner. Outside, its depth decays over one length,
// the lift-off length l (Winkler's bed under tension; K. L. Johnson, Contact Mechanics, 4.3). With
// r the radius of the cap that the ball cuts out of the untouched face,
//   a = sqrt(l^2 + r^2) - l,   depth = depth(a) exp(-(rho - a) / l)   for rho > a.
// Without l the skin follows the ball up to the rim of its cap. Where the fit reads the rim, all
// depths then come out too deep, by ten times the error there.

/// The untouched face below a ball, as a plane.
struct PressedPlane {
  Eigen::Vector3d point_mm = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  [[nodiscard]] double height_mm(const Eigen::Vector3d& centre_mm) const {
    return normal.dot(centre_mm - point_mm);
  }
};
/// At the sample nearest to the ball's centre.
[[nodiscard]] PressedPlane plane_below(const PressSamples& press, const Eigen::Vector3d& centre_mm);

/// Prior of the lift-off length of silicone skins, within a factor of e.
constexpr double kTypicalLiftMm = 0.12;

/// Distance from the ball's axis at which the skin leaves the ball, mm, for a given r^2.
[[nodiscard]] double contact_radius_mm(double rim2_mm2, double lift_mm);

/// Depth of an elastic half space around a ball, as a part of that at the contact's edge, at `q` =
/// r over the contact's radius, from 1. K. L. Johnson, Contact Mechanics, 3.42a.
[[nodiscard]] double half_space_tail(double q);

/// Depth of the skin, normal to the plane.
struct SkinDepth {
  double mm = 0;
  double by_ball = 1;    ///< by the ball's depth at the same position
  double by_height = 0;  ///< by the height of the ball's centre over the plane
  double by_lift = 0;    ///< by the lift-off length
};
/// `ball_mm`: depth of the ball at the position, normal to the plane, negative outside its cap.
/// `lift_mm` 0: the skin follows the ball everywhere.
[[nodiscard]] SkinDepth skin_depth(double ball_mm, double height_mm, double radius_mm,
                                   double lift_mm);

/// How deep a ball presses in at a sample, mm, in the direction of `along`, negative where the ball
/// is off the face; with its derivative by the centre. NaN where the line misses the ball.
[[nodiscard]] double ball_depth_mm(const Sample& sample, MappingAlong along,
                                   const Eigen::Vector3d& centre_mm, double radius_mm,
                                   Eigen::Vector3d* by_centre = nullptr);

/// How deep the skin is pressed in at a sample by a ball, with the lift-off of contact_model.h, in
/// the direction of `along`. Derivatives by the centre and by the lift-off length (may be null).
[[nodiscard]] double skin_depth_mm(const Sample& sample, MappingAlong along,
                                   const Eigen::Vector3d& centre_mm, double radius_mm,
                                   const PressedPlane& plane, double lift_mm,
                                   Eigen::Vector3d* by_centre = nullptr, double* by_lift = nullptr);

/// How much deeper a sample reads than the ball is at its middle, mm. A sample is a mean over some
/// pixels (PressSamples::blur_px2), and the mean of a curved function is not its middle value. By
/// the second derivatives of x = g(d) over the image, g the curve's inverse:
///   blur / 2 (laplacian d - M'' / M'^2 |gradient d|^2).
/// Two thousandths of a millimetre in the middle of a contact become a hundredth in the scale of
/// all depths, because the ball's centre yields. 0 where the ball's edge is near.
[[nodiscard]] double blur_mm(const Sample& sample, const PressSamples& press, const CurveAt& curve,
                             MappingAlong along, const Eigen::Vector3d& centre_mm,
                             const PressedPlane& plane = {}, double lift_mm = 0.0);

/// Position of samples in the contact: 0 at its middle, 1 at the rim of the ball's cap, where the
/// skin would leave the ball without lift-off.
class ContactDisc {
 public:
  ContactDisc(const PressSamples& press, MappingAlong along, const Eigen::Vector3d& centre_mm);

  /// Position in the contact of the skin over a sample.
  struct Position {
    /// fraction of the rim's radius; infinite where the sample's line misses the ball
    double radius;
    int patch;  ///< 0..kPatches-1: rings as below, 8 sectors each
  };
  [[nodiscard]] Position position_of(const Sample& sample) const;
  /// The untouched face below the ball.
  [[nodiscard]] const PressedPlane& plane() const { return plane_; }
  static constexpr int kRings = 7;
  static constexpr int kSectors = 8;
  static constexpr int kPatches = kRings * kSectors;
  /// Outer radii of the rings.
  static constexpr double kRingRadius[kRings] = {0.35, 0.5, 0.65, 0.75, 0.85, 0.93, 1.0};

 private:
  MappingAlong along_;
  Eigen::Vector3d centre_mm_;
  double radius_mm_;
  PressedPlane plane_;
  double rim2_ = 1;  ///< squared radius of the cap's rim
};

/// Fraction of the rim's radius within which skin and ball touch on any material (Hertz: 0.71).
constexpr double kInnerZone = 0.65;
constexpr double kFloorMm = 0.003;  ///< smallest standard deviation of a sample, across the ball

}  // namespace alltact
